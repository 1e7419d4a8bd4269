#include "harness/studies/sheet/sheet_files.h"

#include "harness/runs/run_directory.h"
#include "harness/studies/sheet/chart.h"
#include "harness/studies/sheet/sheet_pictures.h"
#include "problems/io/replace_file.h"

namespace lcp {

void write_sheet(const Sheet& sheet, const std::filesystem::path& directory) {
  const bool timed = sheet.options.measure == Measure::time;
  const std::string of_measure = timed ? "" : "-" + to_string(sheet.options.measure);
  const auto path = [&](const std::string& name, const std::string& rest) {
    return directory / (name + of_measure + rest);
  };
  make_directories(directory);
  replace_file(path("sheet", ".txt").string(), render(sheet, SheetFormat::text));
  replace_file(path("sheet", ".csv").string(), render(sheet, SheetFormat::csv));
  replace_file(path("sheet", ".json").string(), render(sheet, SheetFormat::json));
  if (drawn_groups(sheet, 1).empty()) return;
  draw_figure(path("chart", ".svg"), chart_figure(sheet));
  draw_figure(path("sheet", "-profile.svg"), profile_figure(sheet));
  if (!sheet.options.accuracies.empty())
    draw_figure(path("sheet", "-cumulative.svg"), cumulative_figure(sheet));
  if (timed && !sheet.options.budgets_ms.empty())
    draw_figure(path("sheet", "-accuracy.svg"), accuracy_figure(sheet));
}

Sheet write_sheet(const std::filesystem::path& directory, const SheetOptions& options,
                  const std::filesystem::path& out) {
  const Sheet sheet = make_sheet(read_run(directory), options);
  write_sheet(sheet, out);
  return sheet;
}

}  // namespace lcp
