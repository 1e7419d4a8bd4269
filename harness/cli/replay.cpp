#include "harness/studies/replay/replay.h"

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/cli/interrupt.h"
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

}  // namespace

Verb add_replay(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "replay", "Follow a solve pivot by pivot beside its rule in 113 bits: the first wrong pivot");
  auto arguments = std::make_shared<ReplayArguments>();
  ReplayOptions& options = arguments->options;
  page->add_option("INSTANCE", arguments->where, "FILE of one instance, or FILE#NAME")->required();
  page->add_option("--solver", arguments->solver, "NAME[:key=value,...]")->required();
  page->add_option("--start", arguments->start, "Where the solver starts: cold, two-step, previous")
      ->check(CLI::IsMember({"cold", "two-step", "previous"}))
      ->capture_default_str();
  page->add_option("--window", arguments->window,
                   "Pivots shown before the first wrong one; half as many after it")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  page->add_flag("--all", arguments->all, "Print every pivot");
  page->add_option("--zero", options.high.zero,
                   "A number is 0 in 113 bits if below this times its estimated error")
      ->check(CLI::Range(1.0, 1e12))
      ->capture_default_str();
  page->add_option("--most-pivots", options.high.most_pivots,
                   "Pivots followed in 113 bits, of a search: pivots checked")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  page->add_option("--largest-condition", options.largest_condition,
                   "Rows above which no condition of the basis is computed; it costs n^3 a pivot")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  page->add_option("--tolerance", options.tolerance,
                   "Largest natural residual (scaled) that counts as solved")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_flag("--json", arguments->json, "As JSON");
  add_reading_option(*page, arguments->reading);
  page->footer(
      "The rules of lemke* and lexicographic* are followed in 113 bits (__float128), where M and q "
      "are\n"
      "exact; the pivots of best-first* are checked one by one from the same basis.\n"
      "Marks: > the first wrong pivot, 0 the first that is none in 113 bits.\n"
      "Example:\n  lcpbench replay squat.hdf5#squat-like/0009 --solver lemke\n"
      "  lcpbench replay squat.hdf5#squat-like/0009 --solver lexicographic:delta=1e-6 --all");
  return {page, [arguments] { return replay_instance(*arguments); }};
}

}  // namespace lcp::cli
