#include "harness/studies/paper/written_forms.h"

#include <fmt/format.h>

#include <stdexcept>

#include "harness/present/escaping.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

std::string figure_json(int figure, const std::vector<LoopSummary>& runs) {
  nlohmann::json json = {{"figure", figure},
                         {"picture", fmt::format("fig{}.svg", figure)},
                         {"data", fmt::format("fig{}.csv", figure)},
                         {"runs", nlohmann::json::array()}};
  for (const LoopSummary& run : runs) json["runs"].push_back(figures_of(run));
  return json.dump(1) + "\n";
}

std::string figure_latex(int figure, const std::vector<LoopSummary>& runs) {
  std::string caption;
  for (const LoopSummary& run : runs)
    caption +=
        fmt::format("{}\\texttt{{{}}} with \\texttt{{{}}} in the loop: {} of {} frames solved.",
                    caption.empty() ? "" : " ", latex_escaped(run.scene), latex_escaped(run.solver),
                    run.success, run.total_frames);
  return fmt::format(
      "% needs the package svg\n\\begin{{figure}}\n\\includesvg[width=\\linewidth]{{fig{}}}\n"
      "\\caption{{{}}}\n\\end{{figure}}\n",
      figure, caption);
}

}  // namespace

void write_each_format(const std::filesystem::path& stem,
                       const std::function<std::string(TableFormat)>& rendered) {
  for (const auto& [ending, format] : {std::pair(".txt", TableFormat::text),
                                       {".csv", TableFormat::csv},
                                       {".json", TableFormat::json},
                                       {".tex", TableFormat::latex}})
    replace_file(stem.string() + ending, rendered(format));
}

std::string render_figure(int figure, const std::vector<LoopSummary>& runs, TableFormat format) {
  switch (format) {
    case TableFormat::text: {
      std::string out;
      for (const LoopSummary& run : runs) out += render(run);
      return out;
    }
    case TableFormat::json:
      return figure_json(figure, runs);
    case TableFormat::latex:
      return figure_latex(figure, runs);
    case TableFormat::csv:
      break;
  }
  throw std::invalid_argument(
      fmt::format("figure {0}: expected text, json or latex; its data is fig{0}.csv", figure));
}

}  // namespace lcp
