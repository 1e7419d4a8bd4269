#include "harness/measure/solve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "harness/cli/page.h"
#include "harness/cli/reading.h"
#include "harness/cli/start.h"
#include "harness/judge/judge.h"
#include "harness/record.h"
#include "harness/studies/trace.h"

namespace lcp::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr Index printed_entries = 12;  ///< Longer z are printed as the rows that are not zero.

struct SolveArguments {
  std::string where;
  ReadOptions reading;
  std::vector<std::string> solvers = {"own"};
  std::vector<std::string> starts = {"cold"};
  double tolerance = 1e-6;
  bool trace = false;
  bool json = false;
};

/// Infinite figures are strings, as in the rows of a run.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return fmt::format("{}", value);
}

Json to_json(const Instance& instance, const NamedSolver& solver, StartKind start,
             const Result& result, const Judgement& judgement) {
  Json json = {{"instance", instance.name},
               {"solver", solver.spelling},
               {"start", to_string(start)},
               {"claim", to_string(result.claim)},
               {"message", result.message},
               {"verdict", to_string(judgement.verdict)},
               {"unclaimed", judgement.unclaimed},
               {"trivial", judgement.trivial},
               {"residual", number(judgement.accuracy.residual)},
               {"backward_error", number(judgement.accuracy.backward_error)},
               {"work", nlohmann::json(result.work)},
               {"z", result.z},
               {"basis", nullptr}};
  if (result.basis) json["basis"] = *result.basis;
  return json;
}

std::string solution(const VectorXd& z) {
  if (z.size() <= printed_entries) return fmt::format("z = {:.6g}", fmt::join(z, " "));
  std::vector<std::string> positive;
  for (Index i = 0; i < z.size(); ++i)
    if (z(i) != 0) positive.push_back(fmt::format("z_{} = {:.6g}", i + 1, z(i)));
  return positive.empty() ? "z = 0" : fmt::format("{}, others 0", fmt::join(positive, ", "));
}

void print(const Instance& instance, const NamedSolver& solver, StartKind start,
           const Result& result, const Judgement& judgement) {
  fmt::print("{} (n = {}), {}{}: {}\n", instance.name, instance.problem.size(), solver.spelling,
             start == StartKind::cold ? "" : fmt::format(" [{}]", to_string(start)),
             to_string(judgement.verdict));
  if (judgement.verdict == Verdict::wrong) fmt::print("  claimed {}\n", to_string(result.claim));
  if (!result.message.empty()) fmt::print("  {}\n", result.message);
  if (judgement.unclaimed) fmt::print("  although its z is a solution\n");
  if (judgement.trivial) fmt::print("  z = 0 is a solution\n");
  fmt::print("  residual {:.2e}, backward error {:.2e}; pivots {}, path {}, nodes {}, sweeps {}\n",
             judgement.accuracy.residual, judgement.accuracy.backward_error, result.work.pivots,
             result.work.path, result.work.nodes, result.work.sweeps);
  if (start == StartKind::two_step)
    fmt::print("  frictionless pivots {}, start pivots {}, restarts {}\n",
               result.work.frictionless_pivots, result.work.start_pivots, result.work.restarts);
  if (start == StartKind::previous)
    fmt::print("  start pivots {}, restarts {}\n", result.work.start_pivots, result.work.restarts);
  fmt::print("  {}\n", solution(result.z));
}

int solve(const SolveArguments& arguments) {
  const std::vector<NamedSolver> solvers = make_solvers(arguments.solvers);
  Json all = Json::array();
  for (const Instance& instance : read_instances(arguments.where, arguments.reading)) {
    for (const NamedSolver& solver : solvers) {
      for (const StartKind start : start_kinds(arguments.starts)) {
        Trace trace(instance.problem);
        Call call;
        if (arguments.trace) call.observer = trace.observer();
        const Result result = solve_instance(*solver.solver, instance, call, start);
        const Judgement judgement = judge(instance, result, arguments.tolerance);
        if (arguments.json) {
          all.push_back(to_json(instance, solver, start, result, judgement));
          if (arguments.trace) all.back()["trace"] = trace.json();
          continue;
        }
        print(instance, solver, start, result, judgement);
        if (arguments.trace) fmt::print("{}", trace.text());
      }
    }
  }
  if (arguments.json) fmt::print("{}\n", Json{{"results", all}}.dump(1));
  return done;
}

void solve_options(CLI::App& page, SolveArguments& arguments) {
  add(page, "INSTANCE", arguments.where, "FILE, FILE#NAME or directory")->required();
  add_with_default(page, "--solver", arguments.solvers,
                   "NAME[:key=value,...], pattern, own (no peers) or all; repeatable");
  add_start_option(page, arguments.starts);
  add_with_default(page, "--tolerance", arguments.tolerance,
                   "Largest natural residual (scaled) that counts as solved", CLI::PositiveNumber);
  page.add_flag("--trace", arguments.trace,
                "Print every pivot: what enters and leaves, ratio, ties, size, condition");
  page.add_flag("--json", arguments.json, "As JSON");
  add_reading_option(page, arguments.reading);
}

}  // namespace

Verb add_solve(CLI::App& program) {
  return make_verb<SolveArguments>(
      program, "solve", "Solve instances in this process, for debuggers and sanitizers; no times",
      solve_options, solve,
      "Example:\n  lcpbench solve squat.hdf5#squat-like/0003 --solver best-first --trace\n"
      "  lcpbench solve squat.hdf5 --solver best-first --start cold --start previous");
}

}  // namespace lcp::cli
