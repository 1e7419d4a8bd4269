#include "harness/studies/paper/published.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/studies/paper/published_json.h"  // Written by embed.cmake at every change.

namespace lcp {

namespace {

using nlohmann::json;

PublishedRow parse_row(const json& object, std::size_t columns) {
  PublishedRow row{object.at("row"), object.at("unit"), {}, object.value("at_most", false)};
  for (const json& value : object.at("values"))
    row.values.push_back(value.is_null() ? std::optional<double>() : value.get<double>());
  if (row.values.size() != columns)
    throw std::invalid_argument(fmt::format("row '{}': {} values, expected {}, one per column",
                                            row.row, row.values.size(), columns));
  return row;
}

PublishedTable parse_table(const json& object) {
  PublishedTable table{.table = object.at("table"),
                       .title = object.at("title"),
                       .section = object.at("section"),
                       .columns = object.at("columns"),
                       .rows = {},
                       .notes = object.at("notes")};
  for (const json& row : object.at("rows"))
    table.rows.push_back(parse_row(row, table.columns.size()));
  return table;
}

}  // namespace

std::optional<double> PublishedTable::value(const std::string& row,
                                            const std::string& column) const {
  const auto place = std::find(columns.begin(), columns.end(), column);
  const PublishedRow* found = find(row);
  if (place == columns.end() || !found) return std::nullopt;
  return found->values[static_cast<std::size_t>(place - columns.begin())];
}

bool PublishedTable::at_most(const std::string& row) const {
  const PublishedRow* found = find(row);
  return found && found->at_most;
}

bool PublishedTable::departs(const std::string& row, const std::string& column,
                             double measured) const {
  const std::optional<double> stated = value(row, column);
  if (!stated) return false;
  return at_most(row) ? !(measured <= *stated) : far_from(measured, *stated);
}

const PublishedRow* PublishedTable::find(const std::string& row) const {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const PublishedRow& each) { return each.row == row; });
  return found == rows.end() ? nullptr : &*found;
}

const PublishedTable& Published::table(int number) const {
  std::vector<int> known;
  for (const PublishedTable& each : tables) {
    if (each.table == number) return each;
    known.push_back(each.table);
  }
  throw std::invalid_argument(
      fmt::format("no published table {}, known are: {}", number, fmt::join(known, ", ")));
}

Published parse_published(const std::string& text) {
  try {
    const json object = json::parse(text);
    Published all{object.at("source"), {}};
    for (const json& table : object.at("tables")) all.tables.push_back(parse_table(table));
    return all;
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("published tables: {}", error.what()));
  }
}

const Published& published() {
  static const Published all = parse_published(published_json);
  return all;
}

bool far_from(double value, double published_value) {
  const double least = std::min(value, published_value), most = std::max(value, published_value);
  return !(most <= 2 * least);
}

}  // namespace lcp
