#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solvers/catalogue.h"
#include "solvers/result.h"

namespace lcp {

/// A method with its options set, ready to solve. It never prints, exits, or reads a clock.
struct Solver : Configured<Result(const Problem&, const Call&)> {
  static constexpr const char* kind = "solver";

  /// Solves LCP(M, q). Mathematics (ray, cycle, singular basis) is a claim; only a caller's mistake
  /// (shape, start out of range) throws. Same input, same pivots and bits.
  Result solve(const Problem& problem, const Call& call = {}) const { return run(problem, call); }
};

/// How suites of the project's own rows run a row; the defaults run a new one as it is.
struct InSuites {
  /// With each of these settings, `key=value,...`, as a row of its own; empty: only where asked for.
  std::vector<std::string> settings = {""};
  int place = 5;  ///< Rows are run and listed in this order, equal ones by name.
};

/// A row of the registry, described.
struct RowInfo {
  std::string name;
  std::string summary;
  std::string source;
  enum class Kind {
    pivoting,   ///< Finite: walks from basis to basis; a result is exact up to rounding.
    iterative,  ///< Approaches a solution to its own tolerance.
  } kind = Kind::pivoting;
  std::string version = "1";         ///< Raised when the row's results change.
  std::string supports = "any M";    ///< To other problems it answers `unsupported`.
  std::string outside_library = {};  ///< "Siconos 4.4.0": of a peer, an outside library's method.
  /// Of a peer: its own tolerances, and who sets them to which values.
  std::string outside_constants = {};
  InSuites in_suites = {};  ///< Suites run peers as they are, whatever stands here.

  bool peer() const { return !outside_library.empty(); }
};

/// One row of the registry: a method with the defaults that make it this variant.
using Row = CatalogueRow<RowInfo, Solver>;

/// Registers a row; `solve(Problem, Options, Call)` is the method.
struct Registration : Registered<RowInfo, Solver> {
  template <class Options, class Table, class Solve>
  Registration(RowInfo info, Options defaults, Table table, Solve solve)
      : Registered(std::move(info), std::move(defaults), table,
                   [solve](const Options& options, const Problem& problem, const Call& call) {
                     return solve(problem, options, call);
                   }) {}
};

/// All rows, sorted by name, so that link order decides nothing.
const std::vector<Row>& registry();

/// Spellings of those of `rows` that are the project's own, as suites run them, by their places.
std::vector<std::string> rows_in_suites(const std::vector<Row>& rows = registry());

/// A peer that this build lacks, because its library was not there.
struct AbsentPeer {
  std::string name;
  std::string outside_library;  ///< "Siconos"
  std::string package;          ///< The Debian package that brings it.
};

/// The peers this build lacks, sorted by name.
const std::vector<AbsentPeer>& absent_peers();

/// A solver in full spelling.
struct NamedSolver {
  std::string spelling;  ///< Name and settings that differ from the row's defaults, in table order.
  RowInfo info;
  std::shared_ptr<Solver> solver;
};

/// The row called `name`; throws std::invalid_argument with the package that an absent peer needs, or
/// with the list of rows.
const Row& find_row(const std::string& name);

/// Makes the solver that `name:key=value,...` describes; throws std::invalid_argument with the list
/// of what is allowed.
NamedSolver make_solver(const std::string& text);

/// True for `own`, `all` and names with `*`, `?` or `[`, settings aside.
bool names_several(const std::string& text);

/// The same for a list in which `all` stands for every row, `own` for every row but the peers, and a
/// name may hold `*`: `best-first*:epsilon=1e-6`. Order is kept, repetitions are dropped.
std::vector<NamedSolver> make_solvers(const std::vector<std::string>& texts);

/// Makes the names of peers that are not built in known, with what would bring them.
struct Absence {
  Absence(const std::vector<std::string>& names, const std::string& library,
          const std::string& package);
};

/// Silences calls into the libraries of peers for the rest of the process, which prints nothing of its own any more: for
/// one that times them.
void silence_outside_calls();

}  // namespace lcp
