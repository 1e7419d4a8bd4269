#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/paper_table.h"

namespace lcp {

/// What every object of the JSON says of its column before the quantities.
nlohmann::ordered_json row_object(int table, const std::string& column, const std::string& solver,
                                  const std::string& mode, const std::string& corpus,
                                  const Acceptance& acceptance);

/// Adds every quantity by its key, null where there is none, and `published` with the printed
/// values of the column.
void add_quantities(nlohmann::ordered_json& object, const PublishedTable& published,
                    const std::string& column,
                    const std::function<std::optional<double>(const PaperQuantity&)>& value_of);

/// The object of a simulation: a row_object with its quantities and where it was computed.
nlohmann::ordered_json loop_object(const PublishedTable& published, const std::string& name,
                                   const LoopColumn& column);

/// The names of the fields of csv_line.
extern const char* const csv_head;

/// One value of a row_object; null for none.
std::string csv_line(const nlohmann::ordered_json& object, const std::string& part,
                     const std::string& quantity, const std::string& unit,
                     const nlohmann::ordered_json& value, const nlohmann::ordered_json& published);

/// The quantities of one object of the JSON that have a value, a line each.
std::string csv_lines(const nlohmann::ordered_json& object, const std::string& part);

/// The lines of a row of a tabular.
std::string latex_row(const PaperQuantity& quantity, const std::vector<PaperLine>& lines);

}  // namespace lcp
