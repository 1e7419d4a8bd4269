#include "harness/studies/paper/columns/corpus_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "harness/runs/run_directory.h"
#include "problems/io/load.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;

constexpr const char* frictionless_ending = "+frictionless";

bool is_frictionless(const std::string& corpus) { return corpus.ends_with(frictionless_ending); }

std::string corpus_of(const Instance& instance) {
  return instance.name.substr(0, instance.name.find('/'));
}

/// The two parts of a file of the corpus, which are started differently.
struct Part {
  const char* name;
  bool frictionless;
  StartKind start;
};
constexpr Part parts[] = {{"frictional", false, StartKind::two_step},
                          {"frictionless", true, StartKind::cold}};

fs::path rows_of(const PaperDirectory& directory, const Part& part, const fs::path& file) {
  return directory.path() / "corpus-rows" / part.name / file.stem();
}

/// Rows without what counting does not need: there may be many.
void slim(Record& record) {
  record.options = nlohmann::json();
  record.message.clear();
  record.stderr_end.clear();
}

/// What stands in a run directory.
struct Standing {
  std::vector<Record> rows;          ///< Of the solvers asked for.
  std::vector<std::string> missing;  ///< Solvers that lack rows.
};

Standing standing_rows(const fs::path& directory, const std::vector<std::string>& solvers) {
  if (!fs::exists(directory / "run.json") || !fs::exists(directory / "rows.jsonl"))
    return {{}, solvers};
  const Index instances = read_run_header(directory).settings.instances;
  std::map<std::string, Index> counts;
  Standing standing;
  for (Record& record : read_run(directory)) {
    if (std::find(solvers.begin(), solvers.end(), record.solver) == solvers.end()) continue;
    ++counts[record.solver];
    slim(record);
    standing.rows.push_back(std::move(record));
  }
  for (const std::string& solver : solvers)
    if (counts[solver] < instances) standing.missing.push_back(solver);
  return standing;
}

/// One part of one file of the corpus that lacks rows.
struct OpenPart {
  fs::path file;
  const Part* part;
  std::vector<std::string> solvers;
};

void run_part(const PaperDirectory& directory, const OpenPart& open, const CorpusRun& run,
              std::vector<Instance> instances, const std::function<void(const std::string&)>& note,
              const std::function<void(const Progress&)>& progress,
              const std::atomic<bool>& interrupted) {
  RunPlan plan;
  for (Instance& instance : instances)
    if (is_frictionless(corpus_of(instance)) == open.part->frictionless)
      plan.instances.push_back(std::move(instance));
  if (plan.instances.empty()) return;
  plan.solvers = make_solvers(open.solvers);
  plan.starts = {open.part->start};
  plan.jobs = run.jobs;
  plan.max_samples = run.samples;
  const Origin origin{
      .suite = {},
      .corpora = {(open.file.parent_path().filename() / open.file.filename()).string()},
      .every = 1,
      .limit = 0};
  const fs::path rows = rows_of(directory, *open.part, open.file);
  make_directories(rows.parent_path());
  run_into(rows, std::move(plan), origin, Existing::resume, note, progress, interrupted);
}

struct Survey {
  std::vector<Record> rows;
  std::vector<OpenPart> open;
};

Survey survey(const PaperDirectory& directory, const ScenesCorpus& corpus,
              const std::vector<std::string>& solvers) {
  Survey all;
  for (const fs::path& file : corpus.files)
    for (const Part& part : parts) {
      Standing standing = standing_rows(rows_of(directory, part, file), solvers);
      std::move(standing.rows.begin(), standing.rows.end(), std::back_inserter(all.rows));
      if (!standing.missing.empty()) all.open.push_back({file, &part, standing.missing});
    }
  return all;
}

std::size_t pairs(const std::vector<OpenPart>& open) {
  std::size_t count = 0;
  for (const OpenPart& each : open) count += each.solvers.size();
  return count;
}

bool failed(const Record& record, const Acceptance& acceptance) {
  return judged(record, acceptance).failure();
}

/// CORPUS and frame of a row, whatever its friction.
std::pair<std::string, std::string> frame_of(const Record& record) {
  std::string corpus = record.corpus;
  if (is_frictionless(corpus))
    corpus.resize(corpus.size() - std::string_view(frictionless_ending).size());
  return {corpus, record.instance.substr(record.instance.find('/') + 1)};
}

}  // namespace

std::vector<CorpusColumn> CorpusRows::columns(const Acceptance& acceptance) const {
  using Key = std::pair<std::string, std::string>;  // corpus, solver
  std::map<Key, CorpusColumn> columns;
  std::map<Key, std::set<std::string>> failed_without;  // frames
  for (const Record& record : records_) {
    if (!is_frictionless(record.corpus) || !failed(record, acceptance)) continue;
    const auto [corpus, frame] = frame_of(record);
    failed_without[{corpus, record.solver}].insert(frame);
  }
  for (const Record& record : records_) {
    if (is_frictionless(record.corpus)) continue;
    const auto [corpus, frame] = frame_of(record);
    CorpusColumn& column = columns[{corpus, record.solver}];
    column.pivots += record.work.pivots;
    column.lcp_ms += 1e-6 * static_cast<double>(record.median_ns().value_or(0));
    if (failed(record, acceptance) && failed_without[{corpus, record.solver}].contains(frame))
      ++column.both_failures;
  }
  std::vector<CorpusColumn> ordered;
  for (TableRow& row : make_table(records_, acceptance).rows) {
    if (is_frictionless(row.corpus)) continue;
    const Key key{row.corpus, row.solver};
    CorpusColumn& column = columns.at(key);
    column.corpus = row.corpus;
    column.solver = row.solver;
    column.acceptance = acceptance;
    column.frictionless_failures = static_cast<Index>(failed_without[key].size());
    column.lcp_ms /= static_cast<double>(row.instances);
    row.success += row.trivial;
    column.counts = std::move(row);
    ordered.push_back(std::move(column));
  }
  return ordered;
}

std::size_t missing_rows(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run) {
  return pairs(survey(directory, corpus, run.solvers).open);
}

CorpusRows run_on_corpus(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run, const std::function<void(const std::string&)>& note,
                         const std::function<void(const Progress&)>& progress,
                         const std::atomic<bool>& interrupted) {
  Survey before = survey(directory, corpus, run.solvers);
  if (before.open.empty()) return CorpusRows(std::move(before.rows));
  // A unit is a part of a file; within it, the share of its pairs that are done.
  constexpr std::size_t unit = 1000;
  Progress state{.done = 0, .total = unit * before.open.size(), .at = {}};
  for (std::size_t i = 0; i < before.open.size() && !interrupted; ++i) {
    const OpenPart& open = before.open[i];
    run_part(
        directory, open, run, load_instances(open.file.string()), note,
        [&](const Progress& within) {
          state.done = unit * i + (within.total > 0 ? unit * within.done / within.total : unit);
          state.at = within.at;
          progress(state);
        },
        interrupted);
  }
  return CorpusRows(survey(directory, corpus, run.solvers).rows);
}

}  // namespace lcp
