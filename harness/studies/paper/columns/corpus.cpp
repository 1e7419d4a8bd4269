#include "harness/studies/paper/columns/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "harness/runs/run_directory.h"
#include "harness/studies/loop/in_the_loop.h"
#include "harness/studies/table/table.h"
#include "problems/io/errors.h"
#include "problems/io/load.h"
#include "problems/io/replace_file.h"
#include "problems/scenes/dump.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view frictionless_ending = "+frictionless";

json to_json(const CorpusQuestion& question) {
  return {{"scene", question.scene},
          {"driver", question.driver},
          {"duration", question.duration ? json(*question.duration) : json()}};
}

/// The work of the process: all of the corpus, then its marker.
void dump(const PaperDirectory& directory, const CorpusQuestion& question, const NamedScene& scene,
          const std::function<void()>& beat) {
  const std::atomic<bool> never = false;
  const fs::path place = directory.path() / "corpus", unfinished = directory.path() / "corpus.tmp";
  CorpusDump corpus(unfinished.string(), scene.spelling, question.driver);
  const LoopRun run = run_in_the_loop(
      scene, make_solver(question.driver), {},
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord&) {
        corpus.add(simulation, frame);
        beat();
      },
      never);
  corpus.close();
  fs::rename(unfinished, place);
  const json marker = {{"question", to_json(question)},
                       {"commit", directory.commit()},
                       {"environment", directory.environment_id()},
                       {"instances", corpus.instances()},
                       {"broken", run.broken}};
  replace_file((directory.path() / "corpus.json").string(), marker.dump(1) + "\n");
}

/// CORPUS of a row's instance, whatever its friction, and whether it has any.
std::pair<std::string, bool> corpus_of(const std::string& corpus) {
  const bool frictional = !corpus.ends_with(frictionless_ending);
  return {corpus.substr(0, corpus.size() - (frictional ? 0 : frictionless_ending.size())),
          frictional};
}

/// One of the two parts of a file of the corpus, which are started differently, with its rows.
struct CorpusPart {
  fs::path file, rows;
  bool frictional;
  std::vector<std::string> missing;  ///< Solvers that lack rows.
};

/// Parts that lack rows; those of run.solvers that are there go to `rows`.
std::vector<CorpusPart> open_parts(const PaperDirectory& directory, const ScenesCorpus& corpus,
                                   const CorpusRun& run, std::vector<Record>& rows) {
  std::vector<CorpusPart> open;
  for (const fs::path& file : corpus.files)
    for (const bool frictional : {true, false}) {
      CorpusPart part{file,
                      directory.path() / "corpus-rows" /
                          (frictional ? "frictional" : "frictionless") / file.stem(),
                      frictional, run.solvers};
      if (fs::exists(part.rows / "run.json") && fs::exists(part.rows / "rows.jsonl")) {
        std::map<std::string, Index> counts;
        for (Record& record : read_run(part.rows)) {
          if (std::find(run.solvers.begin(), run.solvers.end(), record.solver) == run.solvers.end())
            continue;
          ++counts[record.solver];
          // There may be many, and counting does not need these.
          record.options = json();
          record.message.clear();
          record.stderr_end.clear();
          rows.push_back(std::move(record));
        }
        std::erase_if(part.missing,
                      [&, all = read_run_header(part.rows).settings.instances](
                          const std::string& solver) { return counts[solver] >= all; });
      }
      if (!part.missing.empty()) open.push_back(std::move(part));
    }
  return open;
}

void run_part(const PaperDirectory& directory, const CorpusPart& part, int samples,
              const std::function<void(const Progress&)>& progress,
              const std::atomic<bool>& interrupted) {
  RunPlan plan;
  for (Instance& instance : load_instances(part.file.string()))
    if (corpus_of(instance.name.substr(0, instance.name.find('/'))).second == part.frictional)
      plan.instances.push_back(std::move(instance));
  if (plan.instances.empty()) return;
  plan.solvers = make_solvers(part.missing);
  plan.starts = {part.frictional ? StartKind::two_step : StartKind::cold};
  plan.jobs = directory.how.jobs;
  plan.max_samples = samples;
  const fs::path corpus = part.file.parent_path().filename() / part.file.filename();
  make_directories(part.rows.parent_path());
  run_into(part.rows, std::move(plan), {.suite = {}, .corpora = {corpus.string()}},
           Existing::resume, directory.how.note, progress, interrupted);
}

}  // namespace

std::optional<ScenesCorpus> find_corpus(const PaperDirectory& directory,
                                        const CorpusQuestion& question) {
  const fs::path marker = directory.path() / "corpus.json", place = directory.path() / "corpus";
  if (!fs::exists(marker) || !fs::is_directory(place)) return std::nullopt;
  const json object = directory.read(marker, to_json(question));
  if (!object.contains("broken") || !object["broken"].is_string())
    throw UnreadableInput(fmt::format("{}: field 'broken' is missing", marker.string()));
  ScenesCorpus corpus{{}, object["broken"]};
  for (const fs::directory_entry& entry : fs::directory_iterator(place))
    if (entry.path().extension() == ".hdf5") corpus.files.push_back(entry.path());
  std::sort(corpus.files.begin(), corpus.files.end());
  return corpus;
}

void dump_corpus(const PaperDirectory& directory, const CorpusQuestion& question,
                 const std::atomic<bool>& interrupted) {
  for (const char* part : {"corpus.json", "corpus", "corpus.tmp"}) {  // the marker first
    std::error_code error;
    fs::remove_all(directory.path() / part, error);
    if (error)
      throw UnwritableOutput(fmt::format("{}: cannot remove {}: {}", directory.path().string(),
                                         part, error.message()));
  }
  const NamedScene scene = scene_lasting(question.scene, question.duration);
  simulate_all(directory,
               {{"corpus of " + question.scene, steps_of(scene),
                 [&](const std::function<void()>& beat) { dump(directory, question, scene, beat); },
                 [&](const std::string& failure) {
                   throw std::runtime_error(fmt::format("the corpus of {}, driven by {}: {}",
                                                        question.scene, question.driver, failure));
                 }}},
               1, interrupted);
}

std::size_t missing_rows(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run) {
  std::vector<Record> rows;
  std::size_t count = 0;
  for (const CorpusPart& part : open_parts(directory, corpus, run, rows))
    count += part.missing.size();
  return count;
}

std::vector<Record> run_on_corpus(const PaperDirectory& directory, const ScenesCorpus& corpus,
                                  const CorpusRun& run, const std::atomic<bool>& interrupted) {
  std::vector<Record> rows;
  const std::vector<CorpusPart> open = open_parts(directory, corpus, run, rows);
  if (open.empty()) return rows;
  rows.clear();
  // A unit is a part of a file; within it, the share of its pairs that are done.
  constexpr std::size_t unit = 1000;
  for (std::size_t i = 0; i < open.size() && !interrupted; ++i)
    run_part(
        directory, open[i], run.samples,
        [&](const Progress& within) {
          const std::size_t share = within.total > 0 ? unit * within.done / within.total : unit;
          directory.how.progress({unit * i + share, unit * open.size(), within.at});
        },
        interrupted);
  open_parts(directory, corpus, run, rows);
  return rows;
}

std::vector<CorpusColumn> corpus_columns(const std::vector<Record>& rows,
                                         const Acceptance& acceptance) {
  struct Sums {
    std::set<std::string> failed[2];  ///< Frames, without friction and with it.
    Index pivots = 0;
    double lcp_ms = 0;
  };
  std::map<std::pair<std::string, std::string>, Sums> all;  // by corpus and solver
  for (const Record& record : rows) {
    const auto [corpus, frictional] = corpus_of(record.corpus);
    Sums& sums = all[{corpus, record.solver}];
    if (judged(record, acceptance).failure())
      sums.failed[frictional].insert(record.instance.substr(record.instance.find('/') + 1));
    if (!frictional) continue;
    sums.pivots += record.work.pivots;
    sums.lcp_ms += 1e-6 * static_cast<double>(record.median_ns().value_or(0));
  }
  std::vector<CorpusColumn> columns;
  const json table = json::parse(render(make_table(rows, acceptance), TableFormat::json));
  for (json row : table.at("rows")) {
    if (!corpus_of(row.at("corpus")).second) continue;
    const Sums& sums = all.at({row.at("corpus"), row.at("solver")});
    const auto& [frictionless, frictional] = sums.failed;
    row["success"] = row.at("success").get<Index>() + row.at("trivial").get<Index>();
    row["total_frames"] = row.at("instances");
    row["total_pivots"] = sums.pivots;
    row["lcp_time_ms"] = sums.lcp_ms / row.at("instances").get<double>();
    row["frictionless_failures"] = frictionless.size();
    row["both_failures"] =
        std::count_if(frictional.begin(), frictional.end(),
                      [&](const std::string& frame) { return frictionless.contains(frame); });
    columns.push_back({row.at("corpus"), row.at("solver"), std::move(row)});
  }
  return columns;
}

}  // namespace lcp
