#include "harness/studies/paper/published.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/studies/paper/published_json.h"  // Written by embed.cmake at every change.

namespace lcp {

namespace {

PublishedTable parse_table(const nlohmann::json& object) {
  PublishedTable table{.table = object.at("table"),
                       .title = object.at("title"),
                       .section = object.at("section"),
                       .columns = object.at("columns"),
                       .rows = {},
                       .notes = object.at("notes")};
  for (const nlohmann::json& each : object.at("rows")) {
    PublishedTable::Row row{each.at("row"), {}, each.value("at_most", false)};
    for (const nlohmann::json& value : each.at("values"))
      row.values.push_back(value.is_null() ? std::optional<double>() : value.get<double>());
    if (row.values.size() != table.columns.size())
      throw std::invalid_argument(fmt::format("row '{}': {} values, expected {}, one per column",
                                              row.key, row.values.size(), table.columns.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

const PublishedTable::Row* PublishedTable::find(const std::string& key) const {
  for (const Row& each : rows)
    if (each.key == key) return &each;
  return nullptr;
}

std::optional<double> PublishedTable::value(const std::string& row,
                                            const std::string& column) const {
  const Row* found = find(row);
  for (std::size_t i = 0; found && i < columns.size(); ++i)
    if (columns[i] == column) return found->values[i];
  return std::nullopt;
}

bool PublishedTable::at_most(const std::string& row) const {
  const Row* found = find(row);
  return found && found->at_most;
}

bool PublishedTable::departs(const std::string& row, const std::string& column,
                             double measured) const {
  const std::optional<double> stated = value(row, column);
  if (!stated) return false;
  return at_most(row) ? !(measured <= *stated) : far_from(measured, *stated);
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
    const nlohmann::json object = nlohmann::json::parse(text);
    Published all{object.at("source"), {}};
    for (const nlohmann::json& table : object.at("tables"))
      all.tables.push_back(parse_table(table));
    return all;
  } catch (const nlohmann::json::exception& error) {
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
