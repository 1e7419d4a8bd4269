#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lcp {

/// A table of the paper as printed.
struct PublishedTable {
  /// A quantity, under the name that `table --format json` gives it.
  struct Row {
    std::string key;
    std::vector<std::optional<double>> values;  ///< One per column; empty where nothing is stated.
    bool at_most = false;  ///< Each value is an upper bound: of the text, which gives no table.
  };

  int table = 0;
  std::string title, section;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  std::vector<std::string> notes;  ///< What the paper's text adds.

  /// Empty where the paper states nothing, also for rows and columns that it does not have.
  std::optional<double> value(const std::string& row, const std::string& column) const;
  /// Whether a row states upper bounds.
  bool at_most(const std::string& row) const;
  /// Whether a measured value is far_from the published one, or above one that is an upper bound;
  /// false where the paper states nothing.
  bool departs(const std::string& row, const std::string& column, double measured) const;

 private:
  const Row* find(const std::string& key) const;  ///< Null where there is none.
};

/// paper/published.json.
struct Published {
  std::string source;
  std::vector<PublishedTable> tables;

  /// Throws std::invalid_argument with the list of tables.
  const PublishedTable& table(int number) const;
};

/// Throws std::invalid_argument saying what is malformed: a field, or a row that does not hold a
/// value per column.
Published parse_published(const std::string& json);

/// The file as it was when the program was built.
const Published& published();

/// Whether a value differs from the published one by more than a factor of 2; 0 differs so from all
/// but 0, and what is no number from everything.
bool far_from(double value, double published_value);

}  // namespace lcp
