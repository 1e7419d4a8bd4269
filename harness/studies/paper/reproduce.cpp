#include "harness/studies/paper/reproduce.h"

#include <fmt/format.h>

#include <algorithm>

#include "problems/scenes/scene.h"

namespace lcp {

namespace {

/// Scenes in full spelling, as simulations and corpora name them; their lengths.
std::vector<double> spell_out(PaperPlan& plan) {
  std::vector<double> lengths;
  for (PaperScene& each : plan.scenes) {
    const NamedScene scene = make_scene(each.scene);
    each.scene = scene.spelling;
    lengths.push_back(scene.setup.length);
  }
  return lengths;
}

LoopQuestion question(const PaperPlan& plan, const PaperScene& scene, const PaperColumn& solver) {
  return {scene.scene, solver.solver, solver.acceptance, plan.duration, solver.limit};
}

/// The simulations whose solver is known: the sweep's, then each solver's by scene.
std::vector<LoopQuestion> questions_of(const PaperPlan& plan) {
  std::vector<LoopQuestion> all;
  for (const std::string& delta : plan.deltas)
    all.push_back(question(plan, plan.scenes.front(), column_of_delta(delta)));
  for (const PaperColumn& solver : plan.solvers)
    for (const PaperScene& scene : plan.scenes)
      if (!solver.solver.empty()) all.push_back(question(plan, scene, solver));
  return all;
}

/// Reads the simulations; the column that the sweep decides gets its solver.
PaperColumns read_simulations(const PaperDirectory& directory, PaperPlan& plan) {
  const auto read = [&](const PaperScene& scene, const PaperColumn& solver) {
    return read_loop_column(directory, question(plan, scene, solver)).value();
  };
  PaperColumns columns;
  for (const std::string& delta : plan.deltas)
    columns.sweep.push_back(read(plan.scenes.front(), column_of_delta(delta)));
  for (PaperColumn& solver : plan.solvers) {
    if (solver.solver.empty())
      solver.solver = columns.sweep.at(best_of(columns.sweep)).question.solver;
    columns.in_loop.emplace_back();
    for (const PaperScene& scene : plan.scenes)
      columns.in_loop.back().push_back(read(scene, solver));
  }
  return columns;
}

CorpusQuestion corpus_question(const PaperPlan& plan) {
  return {plan.scenes.front().scene, plan.driver, plan.duration};
}

CorpusRun corpus_run(const PaperPlan& plan) {
  CorpusRun run{{}, plan.samples};
  for (const PaperColumn& each : plan.solvers)
    if (std::find(run.solvers.begin(), run.solvers.end(), each.solver) == run.solvers.end())
      run.solvers.push_back(each.solver);
  return run;
}

}  // namespace

std::optional<PaperTable> reproduce(PaperPlan plan, const Reproduction& how,
                                    const std::atomic<bool>& interrupted) {
  std::vector<double> lengths = spell_out(plan);
  const PaperDirectory directory(how);
  compute_loop_columns(directory, questions_of(plan), interrupted);
  if (interrupted) return std::nullopt;
  PaperColumns columns = read_simulations(directory, plan);
  columns.lengths = std::move(lengths);
  if (plan.driver.empty()) return set_together(plan, columns);

  const CorpusQuestion asked = corpus_question(plan);
  if (!find_corpus(directory, asked)) dump_corpus(directory, asked, interrupted);
  if (interrupted) return std::nullopt;
  const ScenesCorpus corpus = find_corpus(directory, asked).value();
  const std::vector<Record> rows = run_on_corpus(directory, corpus, corpus_run(plan), interrupted);
  if (interrupted) return std::nullopt;
  columns.by_paper = corpus_columns(rows, by_paper);
  columns.by_residual = corpus_columns(rows, second_look);
  PaperTable table = set_together(plan, columns);
  if (!corpus.broken.empty())
    table.broken.push_back("The simulation of the corpus ended early: " + corpus.broken);
  return table;
}

std::vector<std::string> missing_work(PaperPlan plan, const Reproduction& how) {
  spell_out(plan);
  std::optional<PaperDirectory> directory;
  if (std::filesystem::exists(how.directory)) directory.emplace(how);
  const std::vector<LoopQuestion> open =
      open_questions(directory ? &*directory : nullptr, questions_of(plan));
  std::vector<std::string> work;
  for (const LoopQuestion& each : open)
    work.push_back(fmt::format("simulation of {} with {}", each.scene, each.solver));
  if (plan.driver.empty()) return work;

  const std::string& scene = plan.scenes.front().scene;
  const std::string rows = fmt::format("rows of the columns on the corpus of {}", scene);
  const std::optional<ScenesCorpus> corpus =
      directory ? find_corpus(*directory, corpus_question(plan)) : std::nullopt;
  if (!corpus) work.push_back(fmt::format("corpus of {}", scene));
  if (!work.empty()) {
    work.push_back(rows);
    return work;
  }
  read_simulations(*directory, plan);
  if (const std::size_t missing = missing_rows(*directory, *corpus, corpus_run(plan)))
    work.push_back(fmt::format("{}: {} of solvers and files", rows, missing));
  return work;
}

}  // namespace lcp
