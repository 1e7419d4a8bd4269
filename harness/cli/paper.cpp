#include <fmt/format.h>

#include <memory>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/quantity.h"
#include "harness/cli/table_formats.h"
#include "harness/cli/verbs.h"
#include "harness/loop/summary.h"
#include "harness/paper/choices.h"
#include "harness/paper/reproduce.h"
#include "harness/paper/scene_table.h"
#include "harness/pictures/paper_figures.h"
#include "harness/progress.h"

namespace lcp::cli {

namespace {

struct PaperArguments {
  int table = 0, figure = 0;
  bool choices = false;
  std::string format = "text";
  bool all_solvers = false;
  bool dry_run = false;
  std::string out = "runs/paper";
  std::optional<int> jobs;
  std::string limit = "10min";
};

Reproduction reproduction(const PaperArguments& arguments, const std::string& name, int jobs) {
  Reproduction how;
  how.directory = arguments.out + "/" + name;
  how.jobs = arguments.jobs.value_or(jobs);
  how.note = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  return how;
}

int say_interrupted(const std::filesystem::path& directory) {
  fmt::print(stderr, "interrupted: what is finished is in {}; the same command goes on\n",
             directory.string());
  return interrupted_by_user;
}

/// Prints what `compute` made in `how`'s directory; it hands back nothing when interrupted.
template <class Compute>
int print(Reproduction how, const PaperArguments& arguments, const Compute& compute) {
  const std::atomic<bool>& interrupted = catch_interruptions();
  decltype(compute(how, interrupted)) made;
  {
    ProgressBar bar;
    how.progress = [&bar](const Progress& progress) { bar.update(progress); };
    made = compute(how, interrupted);
  }
  if (!made) return say_interrupted(how.directory);
  fmt::print("{}", render(*made, table_formats().at(arguments.format)));
  std::fflush(stdout);
  fmt::print(stderr, "all that it comes from is in {}\n", how.directory.string());
  return done;
}

/// What is still to be computed.
template <class Plan>
int print_missing(const Plan& plan, const Reproduction& how) {
  for (const std::string& line : missing_work(plan, how)) fmt::print("{}\n", line);
  return done;
}

int print_scenes(const PaperArguments& arguments) {
  ScenePlan plan = scene_plan(arguments.all_solvers);
  plan.limit = std::chrono::duration<double>(parse_duration(arguments.limit, "--limit")).count();
  const Reproduction how = reproduction(arguments, "table3", plan.jobs);
  if (arguments.dry_run) return print_missing(plan, how);
  return print(how, arguments, [&](const Reproduction& with, const std::atomic<bool>& interrupted) {
    return simulate_scenes(plan, with, interrupted);
  });
}

int print_table(const PaperArguments& arguments) {
  if (arguments.table == 3) return print_scenes(arguments);
  const PaperPlan plan = paper_plan(arguments.table, arguments.all_solvers);
  const Reproduction how =
      reproduction(arguments, fmt::format("table{}", arguments.table), plan.jobs);
  if (arguments.dry_run) return print_missing(plan, how);
  return print(how, arguments, [&](const Reproduction& with, const std::atomic<bool>& interrupted) {
    return reproduce(plan, with, interrupted);
  });
}

int print_choices(const PaperArguments& arguments) {
  return print(reproduction(arguments, "choices", 2), arguments,
               [](const Reproduction& with, const std::atomic<bool>& interrupted) {
                 return decide_each_way(with, std::nullopt, interrupted);
               });
}

std::size_t steps_of(const NamedScene& scene) {
  return static_cast<std::size_t>(std::lround(scene.setup.duration / scene.setup.stepping.dt));
}

void print_summary(const LoopRun& run, const NamedScene& scene) {
  fmt::print("{}",
             render(summarise(run, scene.setup.system.model.mass(), scene.setup.system.gravity)));
}

int draw_figure_4(const PaperArguments& arguments) {
  const std::vector<FilmedScene> filmed = figure_4_scenes();
  std::size_t done_steps = 0, steps = 0;
  for (const FilmedScene& film : filmed) steps += steps_of(film.scene);
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::vector<LoopRun> runs;
  {
    ProgressBar bar;
    const FrameLook look = [&](const Simulation&, const Frame&, const FrameRecord&) {
      bar.update({++done_steps, steps, "figure 4"});
    };
    runs = write_figure_4(arguments.out, filmed, make_solver("best-first"), {}, look, interrupted);
  }
  if (interrupted) return say_interrupted(arguments.out);
  for (std::size_t i = 0; i < runs.size(); ++i) print_summary(runs[i], filmed[i].scene);
  std::fflush(stdout);
  fmt::print(stderr, "figure, script and data are {0}/fig4.svg, fig4.gp and fig4.dat\n",
             arguments.out);
  return done;
}

int draw_figure(const PaperArguments& arguments) {
  if (arguments.figure == 4) return draw_figure_4(arguments);
  const std::filesystem::path directory = arguments.out;
  const NamedScene scene = make_scene(arguments.figure == 2 ? "squat" : "tap-dance");
  const auto draw = arguments.figure == 2 ? write_figure_2 : write_figure_3;
  const std::atomic<bool>& interrupted = catch_interruptions();
  LoopRun run;
  {
    ProgressBar bar;
    const std::size_t steps = steps_of(scene);
    const FrameLook look = [&](const Simulation&, const Frame&, const FrameRecord& record) {
      bar.update({static_cast<std::size_t>(record.frame), steps, scene.spelling});
    };
    run = draw(directory, scene, make_solver("best-first"), {}, look, interrupted);
  }
  if (interrupted) return say_interrupted(directory);
  print_summary(run, scene);
  std::fflush(stdout);
  fmt::print(stderr,
             "figure, script and data are {0}/fig{1}.svg, fig{1}.gp, fig{1}.dat and fig{1}.csv\n",
             arguments.out, arguments.figure);
  return done;
}

int reproduce_paper(const PaperArguments& arguments) {
  if (arguments.choices) return print_choices(arguments);
  if (arguments.figure != 0) return draw_figure(arguments);
  if (arguments.table != 0) return print_table(arguments);
  throw std::invalid_argument("expected one of --table, --figure, --choices");
}

}  // namespace

Verb add_paper(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "paper", "The paper's tables, published and measured side by side, and its figures");
  auto arguments = std::make_shared<PaperArguments>();
  CLI::Option* table = page->add_option("--table", arguments->table,
                                        "1: squat, 2: tap-dance, or 3: hoist, ring and net")
                           ->check(CLI::IsMember({1, 2, 3}));
  CLI::Option* figure = page->add_option("--figure", arguments->figure,
                                         "2: forces of the feet in squat, 3: tap-dance in time, or "
                                         "4: hoist, ring and net in time")
                            ->check(CLI::IsMember({2, 3, 4}))
                            ->excludes(table);
  page->add_flag("--choices", arguments->choices,
                 "What each choice that the paper leaves open does in the loop")
      ->excludes(table)
      ->excludes(figure);
  page->add_option("--format", arguments->format, "How it is printed")
      ->check(CLI::IsMember(&table_formats()))
      ->capture_default_str();
  page->add_flag("--all-solvers", arguments->all_solvers,
                 "Also a column for every other row of the registry");
  page->add_option("--limit", arguments->limit,
                   "With --table 3 --all-solvers: computing time after which a simulation of one "
                   "of those is stopped")
      ->capture_default_str();
  page->add_flag("--dry-run", arguments->dry_run, "Print what is still to be computed");
  page->add_option("--out", arguments->out, "Directory in which simulations and rows are kept")
      ->capture_default_str();
  page->add_option(
          "--jobs", arguments->jobs,
          "Simulations at the same time; disturbs the times. Default: 2 for table 1, which "
          "has none, 1 for tables 2 and 3")
      ->check(CLI::Range(1, 1024));
  page->footer(
      "One of --table, --figure, --choices. Computes what DIR/tableN does not hold yet: an "
      "interrupted command goes on when repeated.\n"
      "Success means the paper's criterion with e_max = 1e-3; beside it counts at residual 1e-6.\n"
      "Table 3 takes a few minutes; with --all-solvers, which adds how long each solver keeps the "
      "bodies together and how far from best-first's motion, hours.\n"
      "Example:\n"
      "  lcpbench paper --table 1");
  return {page, [arguments] { return reproduce_paper(*arguments); }};
}

}  // namespace lcp::cli
