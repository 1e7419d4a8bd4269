#include "harness/studies/paper/reproduce.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "problems/scenes/scene.h"

namespace lcp {

namespace {

/// Column and scene as a question.
LoopQuestion question(const PaperPlan& plan, const std::string& scene, const PaperColumn& column) {
  return {scene, column.solver, column.acceptance, plan.duration};
}

/// The simulations whose solver is known from the start.
std::vector<LoopQuestion> questions_of(const PaperPlan& plan) {
  std::vector<LoopQuestion> all;
  for (const std::string& delta : plan.deltas)
    all.push_back(question(plan, plan.scene, column_of_delta(delta)));
  std::vector<std::string> scenes{plan.scene};
  if (plan.beside) scenes.push_back(*plan.beside);
  for (const std::string& scene : scenes)
    for (const PaperColumn& column : plan.columns) {
      if (column.solver.empty()) continue;
      const LoopQuestion each = question(plan, scene, column);
      if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
    }
  return all;
}

std::vector<LoopQuestion> open_questions(const PaperDirectory& directory, const PaperPlan& plan) {
  std::vector<LoopQuestion> open = questions_of(plan);
  std::erase_if(open, [&](const LoopQuestion& each) {
    return read_loop_column(directory, each).has_value();
  });
  return open;
}

std::vector<LoopColumn> read_all(const PaperDirectory& directory, const PaperPlan& plan,
                                 const std::string& scene,
                                 const std::vector<PaperColumn>& columns) {
  std::vector<LoopColumn> all;
  for (const PaperColumn& column : columns)
    all.push_back(read_loop_column(directory, question(plan, scene, column)).value());
  return all;
}

/// Reads the simulations; the column that the sweep decides gets its solver.
void read_simulations(const PaperDirectory& directory, PaperTable& table) {
  PaperPlan& plan = table.plan;
  std::vector<PaperColumn> swept;
  for (const std::string& delta : plan.deltas) swept.push_back(column_of_delta(delta));
  table.sweep = read_all(directory, plan, plan.scene, swept);
  for (PaperColumn& column : plan.columns)
    if (column.solver.empty()) column.solver = swept.at(best_of(table.sweep)).solver;
  table.in_loop = read_all(directory, plan, plan.scene, plan.columns);
  if (plan.beside) table.beside = read_all(directory, plan, *plan.beside, plan.columns);
}

/// Notes that many run directories repeat are told once.
std::function<void(const std::string&)> each_once(
    const std::function<void(const std::string&)>& note) {
  return [note, told = std::make_shared<std::set<std::string>>()](const std::string& line) {
    if (told->insert(line).second) note(line);
  };
}

/// Scenes in full spelling, as simulations and corpora name them.
void spell_out(PaperPlan& plan) {
  plan.scene = make_scene(plan.scene).spelling;
  if (plan.beside) plan.beside = make_scene(*plan.beside).spelling;
}

CorpusRun corpus_run(const PaperPlan& plan, int jobs) {
  CorpusRun run{.solvers = {}, .jobs = jobs, .samples = plan.samples};
  for (const PaperColumn& column : plan.columns)
    if (std::find(run.solvers.begin(), run.solvers.end(), column.solver) == run.solvers.end())
      run.solvers.push_back(column.solver);
  return run;
}

}  // namespace

std::optional<PaperTable> reproduce(PaperPlan plan, const Reproduction& how,
                                    const std::atomic<bool>& interrupted) {
  spell_out(plan);
  const auto note = each_once(how.note);
  const PaperDirectory directory(how.directory, how.jobs, note);
  PaperTable table;
  table.plan = std::move(plan);
  table.published = published().table(table.plan.table);
  table.source = published().source;

  compute_loop_columns(directory, open_questions(directory, table.plan), how.jobs, how.progress,
                       interrupted);
  if (interrupted) return std::nullopt;
  read_simulations(directory, table);

  const CorpusQuestion asked{table.plan.scene, table.plan.driver, table.plan.duration};
  if (!find_corpus(directory, asked)) dump_corpus(directory, asked, how.progress, interrupted);
  if (interrupted) return std::nullopt;
  const ScenesCorpus corpus = find_corpus(directory, asked).value();
  if (!corpus.broken.empty())
    table.note = fmt::format("The simulation of the corpus ended early: {}", corpus.broken);

  const CorpusRows rows = run_on_corpus(directory, corpus, corpus_run(table.plan, how.jobs), note,
                                        how.progress, interrupted);
  if (interrupted) return std::nullopt;
  table.by_paper = rows.columns(by_paper);
  table.by_residual = rows.columns(table.plan.second_look);
  return table;
}

std::vector<std::string> missing_work(PaperPlan plan, const Reproduction& how) {
  spell_out(plan);
  std::vector<std::string> work;
  const auto say = [&](const LoopQuestion& each) {
    work.push_back(fmt::format("simulation of {} with {}", each.scene, each.solver));
  };
  const std::string corpus = fmt::format("corpus of {}", plan.scene);
  const std::string rows = fmt::format("rows of the columns on the corpus of {}", plan.scene);
  if (!std::filesystem::exists(how.directory)) {
    for (const LoopQuestion& each : questions_of(plan)) say(each);
    work.insert(work.end(), {corpus, rows});
    return work;
  }
  const PaperDirectory directory(how.directory, how.jobs, how.note);
  const std::vector<LoopQuestion> open = open_questions(directory, plan);
  for (const LoopQuestion& each : open) say(each);
  const std::optional<ScenesCorpus> found =
      find_corpus(directory, {plan.scene, plan.driver, plan.duration});
  if (!found) work.push_back(corpus);
  if (!found || !open.empty()) {
    work.push_back(rows);
    return work;
  }
  PaperTable table;
  table.plan = std::move(plan);
  read_simulations(directory, table);
  if (const std::size_t missing = missing_rows(directory, *found, corpus_run(table.plan, how.jobs)))
    work.push_back(fmt::format("{}: {} of solvers and files", rows, missing));
  return work;
}

}  // namespace lcp
