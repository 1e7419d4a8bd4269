#include "harness/studies/paper/data_rows.h"

#include <fmt/format.h>

#include "harness/present/escaping.h"
#include "solvers/options.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

Json number(const PaperQuantity& quantity, const std::optional<double>& value) {
  if (!value) return nullptr;
  return quantity.counted ? Json(static_cast<Index>(*value)) : Json(*value);
}

std::string text_of(const Json& number) {
  return number.is_null() ? "" : shortest(number.get<double>());
}

}  // namespace

Json row_object(int table, const std::string& column, const std::string& solver,
                const std::string& mode, const std::string& corpus, const Acceptance& acceptance) {
  return {{"table", table},
          {"column", column},
          {"solver", solver},
          {"corpus", corpus},
          {"mode", mode},
          {"criterion", to_string(acceptance.criterion)},
          {"tolerance", acceptance.tolerance}};
}

void add_quantities(Json& object, const PublishedTable& published, const std::string& column,
                    const std::function<std::optional<double>(const PaperQuantity&)>& value_of) {
  Json printed_values;
  for (const PaperQuantity& quantity : paper_quantities()) {
    object[quantity.key] = number(quantity, value_of(quantity));
    if (const auto value = published.value(quantity.key, column))
      printed_values[quantity.key] = number(quantity, value);
  }
  object["instances"] = object["total_frames"];
  if (!printed_values.is_null()) object["published"] = printed_values;
}

Json loop_object(const PublishedTable& published, const std::string& name,
                 const LoopColumn& column) {
  Json object = row_object(published.table, name, column.question.solver, "in-loop",
                           column.question.scene, column.question.acceptance);
  add_quantities(object, published, name,
                 [&](const PaperQuantity& quantity) { return quantity.in_loop(column); });
  object["broken"] = column.summary.broken;
  object["jobs"] = column.jobs;
  object["environment"] = column.environment;
  object["commit"] = column.commit;
  return object;
}

const char* const csv_head =
    "table,part,mode,corpus,criterion,tolerance,column,solver,quantity,unit,value,published\n";

std::string csv_line(const Json& object, const std::string& part, const std::string& quantity,
                     const std::string& unit, const Json& value, const Json& published) {
  const auto text = [&](const char* key) { return object.at(key).template get<std::string>(); };
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", object.at("table").get<int>(), part,
                     text("mode"), csv_quoted(text("corpus")), text("criterion"),
                     shortest(object.at("tolerance").get<double>()), csv_quoted(text("column")),
                     csv_quoted(text("solver")), quantity, unit, text_of(value),
                     text_of(published));
}

std::string csv_lines(const Json& object, const std::string& part) {
  const Json published = object.value("published", Json::object());
  std::string lines;
  for (const PaperQuantity& quantity : paper_quantities()) {
    const Json& value = object.at(quantity.key);
    const Json beside = published.value(quantity.key, Json());
    if (value.is_null() && beside.is_null()) continue;
    lines += csv_line(object, part, quantity.key, quantity.unit, value, beside);
  }
  return lines;
}

std::string latex_row(const PaperQuantity& quantity, const std::vector<PaperLine>& lines) {
  std::string out, label = latex_escaped(quantity.label);
  if (label.starts_with("  ")) label = "\\quad " + label.substr(2);
  for (const PaperLine& line : lines) {
    out += label + " & " + line.label;
    for (const PaperCell& cell : line.cells)
      out += " & " + (cell.value ? printed(quantity, *cell.value) + (cell.far ? "*" : "") : "--");
    out += " \\\\\n";
    label.clear();
  }
  return out;
}

}  // namespace lcp
