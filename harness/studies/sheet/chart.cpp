#include "harness/studies/sheet/chart.h"

#include <stdexcept>

#include "harness/present/gnuplot.h"
#include "harness/studies/sheet/chart_panels.h"
#include "harness/studies/sheet/chart_script.h"
#include "problems/io/replace_file.h"

namespace lcp {

void draw_chart(const Sheet& sheet, const std::filesystem::path& svg) {
  const std::vector<ChartPanel> panels = chart_panels(sheet);
  if (panels.empty()) throw std::invalid_argument("no run to draw: none is counted in any corpus");
  const ChartFiles files = chart_files(panels, sheet, svg.stem().string());
  const std::filesystem::path gp = std::filesystem::path(svg).replace_extension(".gp");
  replace_file(std::filesystem::path(svg).replace_extension(".dat").string(), files.data);
  replace_file(gp.string(), files.script);
  run_gnuplot(gp, svg);
}

}  // namespace lcp
