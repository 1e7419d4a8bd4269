#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/paper/paper_table.h"
#include "harness/tables/escaping.h"
#include "solvers/options.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

Json number(const PaperQuantity& quantity, const std::optional<double>& value) {
  if (!value) return nullptr;
  return quantity.counted ? Json(static_cast<Index>(*value)) : Json(*value);
}

/// What every object says of its column before the quantities.
Json object_of(const PaperTable& table, const std::string& column, const std::string& solver,
               const char* mode, const std::string& corpus, const Acceptance& acceptance) {
  return {{"table", table.plan.table},
          {"column", column},
          {"solver", solver},
          {"corpus", corpus},
          {"mode", mode},
          {"criterion", to_string(acceptance.criterion)},
          {"tolerance", acceptance.tolerance}};
}

template <class Value>
void add_quantities(Json& object, const PaperTable& table, const std::string& column,
                    Value value_of) {
  Json published;
  for (const PaperQuantity& quantity : paper_quantities()) {
    object[quantity.key] = number(quantity, value_of(quantity));
    if (const auto printed = table.published.value(quantity.key, column))
      published[quantity.key] = number(quantity, printed);
  }
  object["instances"] = object["total_frames"];
  if (!published.is_null()) object["published"] = published;
}

Json loop_object(const PaperTable& table, const std::string& name, const LoopColumn& column) {
  Json object = object_of(table, name, column.question.solver, "in-loop", column.question.scene,
                          column.question.acceptance);
  add_quantities(object, table, name,
                 [&](const PaperQuantity& quantity) { return quantity.in_loop(column); });
  object["broken"] = column.summary.broken;
  object["jobs"] = column.jobs;
  object["environment"] = column.environment;
  object["commit"] = column.commit;
  return object;
}

Json corpus_object(const PaperTable& table, const std::string& name, const CorpusColumn& column) {
  Json object = object_of(table, name, column.solver, "corpus", column.corpus, column.acceptance);
  add_quantities(object, table, name,
                 [&](const PaperQuantity& quantity) { return quantity.on_corpus(column); });
  return object;
}

Json rows_of(const PaperTable& table) {
  Json rows = Json::array();
  const std::vector<PaperColumn>& columns = table.plan.columns;
  for (const auto* simulations : {&table.in_loop, &table.beside})
    for (std::size_t i = 0; i < simulations->size(); ++i)
      rows.push_back(loop_object(table, columns[i].name, (*simulations)[i]));
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
    sweep.push_back(loop_object(table, table.sweep[i].question.solver, table.sweep[i]));
  return sweep;
}

/// The values of one object of the JSON, a line each.
std::string csv_lines(const Json& object, const char* part) {
  const auto text = [&](const char* key) { return object.at(key).template get<std::string>(); };
  const Json published = object.value("published", Json::object());
  std::string lines;
  for (const PaperQuantity& quantity : paper_quantities()) {
    const Json& value = object.at(quantity.key);
    if (value.is_null() && !published.contains(quantity.key)) continue;
    lines += fmt::format("{},{},{},{},{},{},{},{},{},{},{},", object.at("table").get<int>(), part,
                         text("mode"), csv_quoted(text("corpus")), text("criterion"),
                         shortest(object.at("tolerance").get<double>()), csv_quoted(text("column")),
                         csv_quoted(text("solver")), quantity.key, quantity.unit,
                         value.is_null() ? "" : shortest(value.get<double>()));
    lines += published.contains(quantity.key)
                 ? shortest(published.at(quantity.key).get<double>()) + "\n"
                 : "\n";
  }
  return lines;
}

std::string latex_rows(const PaperTable& table, const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) {
    const PaperQuantity& quantity = paper_quantity(key);
    std::string label = latex_escaped(quantity.label);
    if (label.starts_with("  ")) label = "\\quad " + label.substr(2);
    for (const PaperLine& line : lines_of(table, quantity)) {
      out += label + " & " + line.label;
      for (const PaperCell& cell : line.cells)
        out += " & " + (cell.value ? printed(quantity, *cell.value) + (cell.far ? "*" : "") : "--");
      out += " \\\\\n";
      label.clear();
    }
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
  std::string out =
      "table,part,mode,corpus,criterion,tolerance,column,solver,quantity,unit,value,published\n";
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
