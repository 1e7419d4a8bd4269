#include <fmt/format.h>

#include <memory>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/table_formats.h"
#include "harness/cli/verbs.h"
#include "harness/studies/loop/summary.h"
#include "harness/studies/paper/choices.h"
#include "harness/studies/paper/paper_figures.h"
#include "harness/studies/paper/reproduce.h"
#include "harness/studies/paper/table_pictures.h"
#include "harness/studies/paper/written_forms.h"
#include "problems/io/replace_file.h"
#include "problems/io/text/read_text.h"

namespace lcp::cli {

namespace {

struct PaperArguments {
  int table = 0, figure = 0;
  bool choices = false, all = false;
  std::string format = "text";
  bool all_solvers = false;
  bool dry_run = false;
  std::string out = "runs/paper";
  std::optional<int> jobs;
  std::string limit = "10min";
};

int say_interrupted(const std::filesystem::path& directory) {
  fmt::print(stderr, "interrupted: what is finished is in {}; the same command goes on\n",
             directory.string());
  return interrupted_by_user;
}

Reproduction reproduction(const PaperArguments& arguments, const std::string& name, int jobs) {
  return {.directory = arguments.out + "/" + name,
          .jobs = arguments.jobs.value_or(jobs),
          .note = [](const std::string& line) { fmt::print(stderr, "{}\n", line); }};
}

/// Prints what `compute` made in `how`'s directory and writes it beside that directory in each
/// format and as a picture; it hands back nothing when interrupted.
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
  const PaperPage page = page_of(*made);
  const auto rendered = [&](TableFormat format) { return render(page, format); };
  fmt::print("{}", rendered(table_formats().at(arguments.format)));
  std::fflush(stdout);
  const std::string stem = how.directory.string() + (arguments.all_solvers ? "-all-solvers" : "");
  write_each_format(stem, rendered);
  draw_figure(stem + ".svg", figure_of(picture_of(*made)));
  fmt::print(stderr,
             "written as {}.txt, .csv, .json, .tex and .svg; all that it comes from is in {}\n",
             stem, how.directory.string());
  return done;
}

int print_table(const PaperArguments& arguments) {
  const double limit =
      std::chrono::duration<double>(parse_duration(arguments.limit, "--limit")).count();
  const PaperPlan plan = paper_plan(arguments.table, arguments.all_solvers, limit);
  const Reproduction how =
      reproduction(arguments, fmt::format("table{}", arguments.table), plan.jobs);
  if (!arguments.dry_run)
    return print(how, arguments, [&](const Reproduction& with, const auto& interrupted) {
      return reproduce(plan, with, interrupted);
    });
  for (const std::string& line : missing_work(plan, how)) fmt::print("{}\n", line);
  return done;
}

int print_choices(const PaperArguments& arguments) {
  return print(reproduction(arguments, "choices", 2), arguments, decide_each_way);
}

/// Draws a figure and prints what ran for it, or its data.
int draw_paper_figure(const PaperArguments& arguments) {
  const int figure = arguments.figure;
  std::vector<FilmedScene> filmed;
  if (figure == 4) {
    filmed = figure_4_scenes();
  } else {
    filmed.push_back({make_scene(figure == 2 ? "squat" : "tap-dance"), {}});
  }
  std::size_t done_steps = 0, steps = 0;
  for (const FilmedScene& film : filmed) steps += steps_of(film.scene);
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::vector<LoopRun> runs;
  {
    ProgressBar bar;
    const FrameLook look = [&](const Simulation&, const Frame&, const FrameRecord&) {
      bar.update({++done_steps, steps, fmt::format("figure {}", figure)});
    };
    const NamedSolver solver = make_solver("best-first");
    if (figure == 4)
      runs = write_figure_4(arguments.out, filmed, solver, {}, look, interrupted);
    else
      runs.push_back(write_figure(figure, arguments.out, filmed.front().scene, solver, {}, look,
                                  interrupted));
  }
  if (interrupted) return say_interrupted(arguments.out);

  std::vector<LoopSummary> summaries;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SceneSetup& setup = filmed[i].scene.setup;
    summaries.push_back(summarise(runs[i], setup.system.model.mass(), setup.system.gravity));
  }
  const std::string stem = fmt::format("{}/fig{}", arguments.out, figure);
  for (const auto& [ending, format] :
       {std::pair(".json", TableFormat::json), {".tex", TableFormat::latex}})
    replace_file(stem + ending, render_figure(figure, summaries, format));
  const TableFormat format = table_formats().at(arguments.format);
  fmt::print("{}", format == TableFormat::csv
                       ? read_text(stem + ".csv", "the figure's data", longest_file)
                       : render_figure(figure, summaries, format));
  std::fflush(stdout);
  fmt::print(stderr, "figure, script and data are {}.svg, .gp, .dat, .csv, .json and .tex\n", stem);
  return done;
}

/// Every table and figure, and the choices; the first that fails or is interrupted ends it.
int reproduce_all(PaperArguments arguments) {
  for (arguments.table = 1; arguments.table <= 3; ++arguments.table)
    if (const int status = print_table(arguments); status != done) return status;
  if (arguments.dry_run) {
    fmt::print("the choices, as far as {}/choices does not hold them\nfigures 2, 3 and 4\n",
               arguments.out);
    return done;
  }
  if (const int status = print_choices(arguments); status != done) return status;
  for (arguments.figure = 2; arguments.figure <= 4; ++arguments.figure)
    if (const int status = draw_paper_figure(arguments); status != done) return status;
  return done;
}

int reproduce_paper(const PaperArguments& arguments) {
  if (arguments.dry_run && arguments.table == 0 && !arguments.all)
    throw std::invalid_argument("--dry-run: expected --table or --all with it");
  if (arguments.all) return reproduce_all(arguments);
  if (arguments.choices) return print_choices(arguments);
  if (arguments.figure != 0) return draw_paper_figure(arguments);
  if (arguments.table != 0) return print_table(arguments);
  throw std::invalid_argument("expected one of --table, --figure, --choices, --all");
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
  CLI::Option* choices =
      page->add_flag("--choices", arguments->choices,
                     "What each choice that the paper leaves open does in the loop")
          ->excludes(table)
          ->excludes(figure);
  page->add_flag("--all", arguments->all, "Every table and figure, and the choices")
      ->excludes(table)
      ->excludes(figure)
      ->excludes(choices);
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
      "One of --table, --figure, --choices, --all. Computes what DIR/tableN does not hold yet: an "
      "interrupted command goes on when repeated. Writes DIR/tableN.txt, .csv, .json, .tex and "
      ".svg.\n"
      "Success means the paper's criterion with e_max = 1e-3; beside it counts at residual 1e-6.\n"
      "Table 3 takes a few minutes; with --all-solvers, which adds how long each solver keeps the "
      "bodies together and how far from best-first's motion, hours.\n"
      "Example:\n"
      "  lcpbench paper --table 1");
  return {page, [arguments] { return reproduce_paper(*arguments); }};
}

}  // namespace lcp::cli
