#include "harness/studies/paper/written_forms.h"

#include <fmt/format.h>

#include <stdexcept>

#include "harness/present/escaping.h"
#include "problems/io/replace_file.h"

namespace lcp {

void write_each_format(const std::filesystem::path& stem,
                       const std::function<std::string(TableFormat)>& rendered) {
  for (const auto& [ending, format] : {std::pair(".txt", TableFormat::text),
                                       {".csv", TableFormat::csv},
                                       {".json", TableFormat::json},
                                       {".tex", TableFormat::latex}})
    replace_file(stem.string() + ending, rendered(format));
}

std::string render_figure(int figure, const std::vector<LoopSummary>& runs, TableFormat format) {
  if (format == TableFormat::csv)
    throw std::invalid_argument(
        fmt::format("figure {0}: expected text, json or latex; its data is fig{0}.csv", figure));
  nlohmann::json json = {{"figure", figure},
                         {"picture", fmt::format("fig{}.svg", figure)},
                         {"data", fmt::format("fig{}.csv", figure)},
                         {"runs", nlohmann::json::array()}};
  std::string text, caption;
  for (const LoopSummary& run : runs) {
    json["runs"].push_back(figures_of(run));
    text += render(run);
    caption +=
        fmt::format("{}\\texttt{{{}}} with \\texttt{{{}}} in the loop: {} of {} frames solved.",
                    caption.empty() ? "" : " ", latex_escaped(run.scene), latex_escaped(run.solver),
                    run.success, run.total_frames);
  }
  if (format == TableFormat::text) return text;
  if (format == TableFormat::json) return json.dump(1) + "\n";
  return fmt::format(
      "% needs the package svg\n\\begin{{figure}}\n\\includesvg[width=\\linewidth]{{fig{}}}\n"
      "\\caption{{{}}}\n\\end{{figure}}\n",
      figure, caption);
}

}  // namespace lcp
