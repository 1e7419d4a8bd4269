#include "harness/studies/laws/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <numeric>
#include <set>

#include "harness/judge/judge.h"
#include "harness/record.h"
#include "harness/studies/laws/law_problems.h"

namespace lcp {

namespace {

using Status = LawOutcome::Status;

LawOutcome holds() { return {Status::holds, ""}; }
LawOutcome broken(std::string why) { return {Status::broken, std::move(why)}; }

/// Checks each sample in turn: the first that breaks the law decides. `check` returns what is wrong, or
/// nothing.
LawOutcome on_every(
    const NamedSolver& solver, const std::vector<NamedProblem>& samples,
    const std::function<std::string(const NamedProblem&, const Result&)>& check_sample) {
  for (const NamedProblem& sample : samples) {
    const std::string wrong = check_sample(sample, solver.solver->solve(sample.problem));
    if (!wrong.empty()) return broken(fmt::format("{}: {}", sample.name, wrong));
  }
  return holds();
}

/// The same of the samples that the row supports; where it supports none, the law does not apply.
LawOutcome on_samples(
    const NamedSolver& solver, const std::vector<NamedProblem>& samples,
    const std::function<std::string(const Problem&, const Result&)>& check_sample) {
  std::string unsupported;
  bool applied = false;
  const LawOutcome outcome =
      on_every(solver, samples, [&](const NamedProblem& sample, const Result& result) {
        if (result.claim == Claim::unsupported) {
          unsupported = result.message;
          return std::string();
        }
        applied = true;
        return check_sample(sample.problem, result);
      });
  return applied ? outcome : LawOutcome{Status::not_applicable, unsupported};
}

bool defined(const VectorXd& z, Index n) { return z.size() == n && z.allFinite(); }

bool same_bits(const VectorXd& a, const VectorXd& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

/// What differs between two answers, or nothing.
std::string difference(const Result& a, const Result& b) {
  if (a.claim != b.claim)
    return fmt::format("claims {} and {}", to_string(a.claim), to_string(b.claim));
  if (nlohmann::json(a.work) != nlohmann::json(b.work))
    return fmt::format("work {} and {}", nlohmann::json(a.work).dump(),
                       nlohmann::json(b.work).dump());
  if (!same_bits(a.z, b.z) || !same_bits(a.w, b.w) || a.z0 != b.z0) return "z, w or z0 differ";
  if (a.basis != b.basis) return "the bases differ";
  if (!same_bits(a.certificate, b.certificate)) return "the certificates differ";
  return "";
}

LawOutcome empty_problem(const NamedSolver& solver) {
  const std::vector<NamedProblem> empty = {{"n = 0", plain_problem(MatrixXd(0, 0), VectorXd(0))}};
  return on_samples(solver, empty, [](const Problem&, const Result& result) -> std::string {
    if (result.claim != Claim::solved) return "claims " + to_string(result.claim);
    if (result.z.size() != 0) return fmt::format("z has {} entries", result.z.size());
    return result.work.pivots == 0 ? "" : fmt::format("took {} pivots", result.work.pivots);
  });
}

LawOutcome nonnegative_q(const NamedSolver& solver) {
  std::vector<NamedProblem> samples = sample_problems();
  for (NamedProblem& sample : samples) {
    sample.problem.q = sample.problem.q.cwiseAbs();
    sample.problem.q(0) = 0;                                       // and a tie with zero
    if (sample.problem.friction) sample.problem.friction.reset();  // its vbar says otherwise
  }
  return on_samples(solver, samples, [](const Problem& problem, const Result& result) {
    if (result.claim != Claim::solved) return "claims " + to_string(result.claim);
    if (!defined(result.z, problem.size()) || !result.z.isZero(0)) return std::string("z is not 0");
    return result.work.pivots == 0 ? "" : fmt::format("took {} pivots", result.work.pivots);
  });
}

LawOutcome repeatable(const NamedSolver& solver) {
  return on_samples(solver, sample_problems(), [&](const Problem& problem, const Result& first) {
    return difference(first, solver.solver->solve(problem));
  });
}

LawOutcome watched(const NamedSolver& solver) {
  return on_samples(solver, sample_problems(), [&](const Problem& problem, const Result& alone) {
    Index events = 0;
    Call call;
    call.observer = [&](const PivotEvent&) { ++events; };
    const std::string changed = difference(alone, solver.solver->solve(problem, call));
    if (!changed.empty() || events <= alone.work.pivots) return changed;
    return fmt::format("{} basis changes reported, {} counted", events, alone.work.pivots);
  });
}

LawOutcome untouched_input(const NamedSolver& solver) {
  const std::vector<NamedProblem> before = sample_problems(), after = sample_problems();
  for (std::size_t i = 0; i < after.size(); ++i) {
    solver.solver->solve(after[i].problem);
    if (content_hash(after[i].problem) != content_hash(before[i].problem))
      return broken(after[i].name + ": the problem was changed");
  }
  return holds();
}

LawOutcome well_formed(const NamedSolver& solver) {
  return on_samples(solver, sample_problems(), [](const Problem& problem, const Result& result) {
    const Index n = problem.size();
    if (result.w.size() != 0 && result.w.size() != n)
      return fmt::format("w has {} entries, expected {} or none", result.w.size(), n);
    if (result.work.path > result.work.pivots)
      return fmt::format("path {} is longer than pivots {}", result.work.path, result.work.pivots);
    if (!result.basis) return std::string();
    const std::vector<Index>& basis = *result.basis;
    const bool ascending =
        std::adjacent_find(basis.begin(), basis.end(), std::greater_equal<>()) == basis.end();
    if (!ascending || (!basis.empty() && (basis.front() < 0 || basis.back() >= n)))
      return std::string("the basis is no ascending list of rows");
    return std::string();
  });
}

/// The samples, and each with one pivot allowed.
std::vector<NamedProblem> samples_and_cut_short() {
  std::vector<NamedProblem> samples = sample_problems();
  for (NamedProblem& sample : sample_problems()) {
    sample.name += ", one pivot";
    sample.problem.pivot_limit = 1;
    samples.push_back(std::move(sample));
  }
  return samples;
}

LawOutcome defined_failure(const NamedSolver& solver) {
  const auto check_z = [](const NamedProblem& sample, const Result& result) {
    if (defined(result.z, sample.problem.size())) return std::string();
    return fmt::format("claims {} without a finite z of n entries", to_string(result.claim));
  };
  return on_every(solver, samples_and_cut_short(), check_z);  // unsupported ones too
}

LawOutcome honest(const NamedSolver& solver) {
  const auto check_claim = [](const NamedProblem& sample, const Result& result) {
    const double tolerance = 1e-6;  // the judge's own default
    const Instance instance = make_instance(sample.name, sample.problem, {});
    const Judgement judgement = judge(instance, result, tolerance);
    if (judgement.verdict != Verdict::wrong && judgement.verdict != Verdict::false_infeasible)
      return std::string();
    return fmt::format("claims {} and fails the check, residual {:.2g}", to_string(result.claim),
                       judgement.accuracy.residual);
  };
  return on_every(solver, samples_and_cut_short(), check_claim);
}

/// How near the permutation law wants a row's solution, in max |dz_i / s_z,i|.
double allowed_error(const NamedSolver& solver) {
  const LawTolerances tolerances;
  if (solver.info.kind != RowInfo::Kind::iterative) return tolerances.pivoting;
  for (const Option& option : solver.solver->options())
    if (option.name == "tolerance") return tolerances.own_tolerances * std::stod(option.get());
  return std::numeric_limits<double>::quiet_NaN();
}

LawOutcome permutation(const NamedSolver& solver) {
  const bool iterative = solver.info.kind == RowInfo::Kind::iterative;
  const double allowed = allowed_error(solver);
  const Index n = 12;
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::reverse(order.begin(), order.begin() + n / 2);  // 5 4 3 2 1 0 6 7 ..., then 5 ahead
  std::rotate(order.begin(), order.begin() + 5, order.end());

  std::string claimed_nothing;
  bool applied = false;
  for (const bool symmetric : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const SolvedProblem plain = strictly_complementary(n, seed, symmetric);
      for (const SolvedProblem& solved : {plain, permuted(plain, order)}) {
        const Result result = solver.solver->solve(solved.problem);
        const std::string claim = to_string(result.claim);
        if (result.claim == Claim::unsupported || (iterative && result.claim != Claim::solved)) {
          claimed_nothing = fmt::format("{}: {}", claim, result.message);
          continue;
        }
        applied = true;
        if (result.claim != Claim::solved || !defined(result.z, n))
          return broken(fmt::format("claims {} on a P-matrix problem", claim));
        const double error =
            (result.z - solved.z).cwiseQuotient(solved.problem.s_z).lpNorm<Eigen::Infinity>();
        if (!(error <= allowed))
          return broken(fmt::format("z is off by {:.2g}, allowed is {:.2g}", error, allowed));
      }
    }
  }
  if (!applied) return {Status::not_applicable, claimed_nothing};
  return holds();
}

/// Options by which a method says when a number counts as zero, or when it has done enough.
const std::set<std::string>& tolerance_names() {
  static const std::set<std::string> names = {"tolerance", "epsilon", "e_max",
                                              "delta",     "pivot",   "max_sweeps"};
  return names;
}

LawOutcome accuracy_ladder(const NamedSolver& solver) {
  const OptionTable table = solver.solver->options();
  const bool wanted = std::any_of(table.begin(), table.end(), [](const Option& option) {
    return tolerance_names().count(option.name) > 0;
  });
  const auto has_ladder = [](const Option& option) { return !option.accuracy_ladder.empty(); };
  if (!std::any_of(table.begin(), table.end(), has_ladder)) {
    if (wanted) return broken("a tolerance or a number of sweeps, but no accuracy option");
    return {Status::not_applicable, "neither tolerance nor sweeps"};
  }
  for (const Option& option : table) {
    for (const std::string& value : option.accuracy_ladder) {
      try {
        make_solver(fmt::format("{}:{}={}", solver.info.name, option.name, value));
      } catch (const std::invalid_argument& error) {
        return broken(fmt::format("refuses its own ladder: {}", error.what()));
      }
    }
  }
  return holds();
}

LawOutcome defaults(const NamedSolver& solver) {
  const std::unique_ptr<Solver> fresh = find_row(solver.info.name).make();
  for (const Option& option : fresh->options()) {
    if (option.doc.empty() || option.accepts.empty())
      return broken(fmt::format("option '{}' is not documented", option.name));
    const std::string value = option.get();
    try {
      option.set(value);
    } catch (const std::invalid_argument& error) {
      return broken(fmt::format("refuses its own default: {}", error.what()));
    }
    if (option.get() != value)
      return broken(fmt::format("{}={} reads back as {}", option.name, value, option.get()));
  }
  return holds();
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> all = {
      {"defaults", "every option is documented, and accepts and keeps its default", defaults},
      {"accuracy-ladder", "an option that trades speed for accuracy has a ladder of valid values",
       accuracy_ladder},
      {"empty-problem", "n = 0 is solved without a pivot", empty_problem},
      {"nonnegative-q", "q >= 0 needs no pivot and gives z = 0", nonnegative_q, true},
      {"permutation", "a P-matrix problem in any order gives its one solution", permutation, true},
      {"repeatable", "the same input twice gives the same claim, work and bits", repeatable},
      {"watched", "an observer changes nothing and sees no more pivots than are counted", watched},
      {"untouched-input", "the problem is as it was", untouched_input},
      {"well-formed", "w, basis and counts have the right shape", well_formed},
      {"defined-failure", "z is defined and finite on every claim", defined_failure},
      {"honest", "no claim of success is false", honest, true},
  };
  return all;
}

LawOutcome check(const Law& law, const NamedSolver& solver) {
  try {
    return law.check(solver);
  } catch (const std::exception& error) {
    return broken(fmt::format("throws: {}", error.what()));
  }
}

}  // namespace lcp
