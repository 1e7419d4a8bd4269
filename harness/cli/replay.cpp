#include "harness/studies/replay/replay.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/cli/interrupt.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/cli/reading.h"
#include "harness/cli/start.h"
#include "harness/cli/verbs.h"
#include "harness/studies/replay/render.h"

namespace lcp::cli {

namespace {

struct ReplayArguments {
  std::string where;
  ReadOptions reading;
  std::string solver;
  std::string start = "cold";
  Index window = 10;
  ReplayOptions options;
  bool all = false;
  bool json = false;
};

ReplayOptions with_window(const ReplayArguments& arguments) {
  ReplayOptions options = arguments.options;
  options.before = arguments.window;
  options.after = arguments.window / 2;
  if (arguments.all) options.before = options.after = std::numeric_limits<int>::max();
  return options;
}

int replay_instance(const ReplayArguments& arguments) {
  const NamedSolver solver = make_solver(arguments.solver);
  const Instance instance = read_instance(arguments.where, arguments.reading);
  const StartKind start = from_string<StartKind>(arguments.start);
  ReplayOptions options = with_window(arguments);
  const std::atomic<bool>& interrupted = catch_interruptions();
  options.high.interrupted = &interrupted;
  Replay replayed;
  {
    ProgressBar bar;
    const std::size_t most = static_cast<std::size_t>(options.high.most_pivots);
    options.high.progress = [&](Index pivots) {
      bar.update({static_cast<std::size_t>(pivots), most, "in 113 bits, at most"});
    };
    replayed = replay(solver, instance, start, options);
  }
  const Index n = instance.problem.size();
  if (arguments.json) {
    nlohmann::ordered_json out = {{"instance", instance.name},
                                  {"n", n},
                                  {"solver", solver.spelling},
                                  {"start", arguments.start}};
    out.update(json(replayed, n));
    fmt::print("{}\n", out.dump(1));
  } else {
    fmt::print("{}", text(replayed,
                          fmt::format("{} (n = {}), {}{}", instance.name, n, solver.spelling,
                                      start == StartKind::cold ? "" : " [" + arguments.start + "]"),
                          n));
  }
  return interrupted ? interrupted_by_user : done;
}

void replay_options(CLI::App& page, ReplayArguments& arguments) {
  ReplayOptions& options = arguments.options;
  add(page, "INSTANCE", arguments.where, "FILE of one instance, or FILE#NAME")->required();
  add(page, "--solver", arguments.solver, "NAME[:key=value,...]")->required();
  add_with_default(page, "--start", arguments.start,
                   "Where the solver starts: cold, two-step, previous",
                   CLI::IsMember({"cold", "two-step", "previous"}));
  add_with_default(page, "--window", arguments.window,
                   "Pivots shown before the first wrong one; half as many after it",
                   CLI::Range(0, 1'000'000));
  page.add_flag("--all", arguments.all, "Print every pivot");
  add_with_default(page, "--zero", options.high.zero,
                   "A number is 0 in 113 bits if below this times its estimated error",
                   CLI::Range(1.0, 1e12));
  add_with_default(page, "--most-pivots", options.high.most_pivots,
                   "Pivots followed in 113 bits, of a search: pivots checked",
                   CLI::Range(1, 1'000'000));
  add_with_default(page, "--largest-condition", options.largest_condition,
                   "Rows above which no condition of the basis is computed; it costs n^3 a pivot",
                   CLI::NonNegativeNumber);
  add_with_default(page, "--tolerance", options.tolerance,
                   "Largest natural residual (scaled) that counts as solved", CLI::PositiveNumber);
  page.add_flag("--json", arguments.json, "As JSON");
  add_reading_option(page, arguments.reading);
}

}  // namespace

Verb add_replay(CLI::App& program) {
  return make_verb<ReplayArguments>(
      program, "replay",
      "Follow a solve pivot by pivot beside its rule in 113 bits: the first wrong pivot",
      replay_options, replay_instance,
      "The rules of lemke* and lexicographic* are followed in 113 bits (__float128), where M and q "
      "are\n"
      "exact; the pivots of best-first* are checked one by one from the same basis.\n"
      "Marks: > the first wrong pivot, 0 the first that is none in 113 bits.\n"
      "Example:\n  lcpbench replay squat.hdf5#squat-like/0009 --solver lemke\n"
      "  lcpbench replay squat.hdf5#squat-like/0009 --solver lexicographic:delta=1e-6 --all");
}

}  // namespace lcp::cli
