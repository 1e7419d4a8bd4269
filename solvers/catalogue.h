#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solvers/names.h"
#include "solvers/options.h"

namespace lcp {

/// Something that computes, with options of its own: a solver, a family of problems, a scene.
template <class Signature>
struct Configured {
  std::function<Signature> run;
  std::function<OptionTable()> options;  ///< Live access to them.
};

/// One row of a catalogue: what it says of itself, of which Info::name is unique, and how to make it
/// with its default options. Thing is a Configured, and Thing::kind what messages call it: "scene".
template <class Info, class Thing>
struct CatalogueRow {
  Info info;
  std::function<std::unique_ptr<Thing>()> make;

  /// A Thing with its options set.
  struct Made {
    std::string spelling;  ///< Name and every option that differs from its default, in table order.
    Info info;
    std::unique_ptr<Thing> thing;
  };

  /// Throws std::invalid_argument with the list of what is allowed on an unknown option or a refused
  /// value.
  Made with(const Spelling& spelling) const {
    std::unique_ptr<Thing> made = make();
    apply(made->options(), spelling, info.name);
    std::string full = full_spelling(info.name, made->options(), make()->options());
    return {std::move(full), info, std::move(made)};
  }
};

/// The rows that files have registered at their feet, sorted by name, so that link order decides nothing.
template <class Info, class Thing>
class Catalogue {
 public:
  using Row = CatalogueRow<Info, Thing>;

  /// The one catalogue of these rows.
  static Catalogue& instance() {
    static Catalogue catalogue;
    return catalogue;
  }

  void add(Row row) {
    const auto place =
        std::upper_bound(rows_.begin(), rows_.end(), row,
                         [](const Row& a, const Row& b) { return a.info.name < b.info.name; });
    rows_.insert(place, std::move(row));
  }

  const std::vector<Row>& rows() const { return rows_; }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Row& row : rows_) names.push_back(row.info.name);
    return names;
  }

  /// The row called `name`; throws std::invalid_argument with the list of rows.
  const Row& find(const std::string& name) const {
    for (const Row& row : rows_)
      if (row.info.name == name) return row;
    refuse_unknown(Thing::kind, name, "known are:", names());
  }

  /// What `name:key=value,...` describes; throws std::invalid_argument with the list of what is
  /// allowed.
  typename Row::Made make(const std::string& text) const {
    const Spelling spelling = parse_spelling(text);
    return find(spelling.name).with(spelling);
  }

 private:
  std::vector<Row> rows_;
};

/// Registers a row for as long as the program runs; construct it at the foot of a file. `table(Options&)`
/// lists the options, `run(Options, ...)` computes.
template <class Info, class Thing>
struct Registered {
  template <class Options, class Table, class Run>
  Registered(Info info, Options defaults, Table table, Run run) {
    const auto make = [=] {
      const auto options = std::make_shared<Options>(defaults);
      auto thing = std::make_unique<Thing>();
      thing->run = [=](const auto&... arguments) { return run(*options, arguments...); };
      thing->options = [=] { return table(*options); };
      return thing;
    };
    Catalogue<Info, Thing>::instance().add({std::move(info), make});
  }
};

}  // namespace lcp
