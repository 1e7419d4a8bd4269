#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/studies/paper/data_rows.h"
#include "harness/studies/paper/paper_table.h"
#include "harness/present/escaping.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

Json corpus_object(const PaperTable& table, const std::string& name, const CorpusColumn& column) {
  Json object =
      row_object(table.plan.table, name, column.solver, "corpus", column.corpus, column.acceptance);
  add_quantities(object, table.published, name,
                 [&](const PaperQuantity& quantity) { return quantity.on_corpus(column); });
  return object;
}

Json rows_of(const PaperTable& table) {
  Json rows = Json::array();
  const std::vector<PaperColumn>& columns = table.plan.columns;
  for (const auto* simulations : {&table.in_loop, &table.beside})
    for (std::size_t i = 0; i < simulations->size(); ++i)
      rows.push_back(loop_object(table.published, columns[i].name, (*simulations)[i]));
  for (const std::string& corpus : corpora_of(table))
    for (const auto* counted : {&table.by_paper, &table.by_residual})
      for (const PaperColumn& column : columns)
        if (const CorpusColumn* found = find_column(*counted, corpus, column.solver))
          rows.push_back(corpus_object(table, column.name, *found));
  return rows;
}

Json sweep_of(const PaperTable& table) {
  Json sweep = Json::array();
  for (std::size_t i = 0; i < table.sweep.size(); ++i)
    sweep.push_back(loop_object(table.published, table.sweep[i].question.solver, table.sweep[i]));
  return sweep;
}

std::string latex_rows(const PaperTable& table, const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) {
    const PaperQuantity& quantity = paper_quantity(key);
    out += latex_row(quantity, lines_of(table, quantity));
  }
  return out;
}

std::string latex_sweep(const PaperTable& table) {
  if (table.sweep.empty()) return "";
  const std::vector<std::string> keys = {"delta", "success", "failure",     "no_solution",
                                         "cycle", "error",   "lcp_time_ms", "total_pivots"};
  std::string out =
      fmt::format("\n% lexicographic in the loop, by threshold\n\\begin{{tabular}}{{{}}}\n",
                  std::string(keys.size(), 'r'));
  for (const std::string& key : keys)
    out += (key == keys.front() ? "" : " & ") + latex_escaped(paper_quantity(key).label);
  out += " \\\\ \\hline\n";
  for (const LoopColumn& column : table.sweep) {
    for (const std::string& key : keys) {
      const PaperQuantity& quantity = paper_quantity(key);
      const std::optional<double> value = quantity.in_loop(column);
      out += (key == keys.front() ? "" : " & ") + (value ? printed(quantity, *value) : "--");
    }
    out += " \\\\\n";
  }
  return out + "\\end{tabular}\n";
}

}  // namespace

std::string paper_json(const PaperTable& table) {
  Json json;
  json["title"] = table.published.title;
  json["source"] = table.source;
  json["rows"] = rows_of(table);
  if (!table.sweep.empty()) json["delta_sweep"] = sweep_of(table);
  return json.dump(1) + "\n";
}

std::string paper_csv(const PaperTable& table) {
  std::string out = csv_head;
  for (const Json& object : rows_of(table)) out += csv_lines(object, "column");
  for (const Json& object : sweep_of(table)) out += csv_lines(object, "delta-sweep");
  return out;
}

std::string paper_latex(const PaperTable& table) {
  std::string out = fmt::format(
      "% {}\n% * differs from the published value by more than a factor of 2; success: "
      "|w - M z - q - z0 c| at most {}, \"at 1e-6\": natural residual\n",
      table.published.title, by_paper.tolerance);
  out +=
      fmt::format("\\begin{{tabular}}{{ll|{}}}\n & ", std::string(table.plan.columns.size(), 'r'));
  for (const PaperColumn& column : table.plan.columns) out += " & " + latex_escaped(column.heading);
  out += " \\\\ \\hline\n" + latex_rows(table, table.plan.rows) + "\\hline\n" +
         latex_rows(table, table.plan.own_rows) + "\\end{tabular}\n";
  return out + latex_sweep(table);
}

}  // namespace lcp
