#include "harness/studies/paper/columns/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "harness/studies/loop/in_the_loop.h"
#include "harness/measure/children.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"
#include "problems/scenes/dump.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto silence = std::chrono::minutes(2);

fs::path place_of(const PaperDirectory& directory) { return directory.path() / "corpus"; }
fs::path marker_of(const PaperDirectory& directory) { return directory.path() / "corpus.json"; }
fs::path unfinished_of(const PaperDirectory& directory) { return directory.path() / "corpus.tmp"; }

json to_json(const CorpusQuestion& question) {
  return {{"scene", question.scene},
          {"driver", question.driver},
          {"duration", question.duration ? json(*question.duration) : json()}};
}

void remove_all_of(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error)
    throw UnwritableOutput(fmt::format("{}: cannot remove: {}", path.string(), error.message()));
}

void move_to_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error)
    throw UnwritableOutput(fmt::format("{}: cannot create: {}", to.string(), error.message()));
}

/// The work of the process: all of the corpus, then its marker.
void dump(const PaperDirectory& directory, const CorpusQuestion& question, const NamedScene& scene,
          const std::function<void()>& beat) {
  const std::atomic<bool> never = false;
  const fs::path unfinished = unfinished_of(directory);
  CorpusDump corpus(unfinished.string(), scene.spelling, question.driver);
  const LoopRun run = run_in_the_loop(
      scene, make_solver(question.driver), {},
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord&) {
        corpus.add(simulation, frame);
        beat();
      },
      never);
  corpus.close();
  remove_all_of(place_of(directory));
  move_to_place(unfinished, place_of(directory));
  const json marker = {{"question", to_json(question)},
                       {"commit", directory.environment().at("commit")},
                       {"environment", directory.environment_id()},
                       {"instances", corpus.instances()},
                       {"broken", run.broken}};
  replace_file(marker_of(directory).string(), marker.dump(1) + "\n");
}

}  // namespace

std::optional<ScenesCorpus> find_corpus(const PaperDirectory& directory,
                                        const CorpusQuestion& question) {
  const fs::path marker = marker_of(directory);
  if (!fs::exists(marker) || !fs::is_directory(place_of(directory))) return std::nullopt;
  const json object = read_json_file(marker);
  ScenesCorpus corpus;
  try {
    if (object.at("question") != to_json(question) ||
        object.at("commit") != directory.environment().at("commit"))
      throw std::invalid_argument(
          fmt::format("{} is of commit {} and {}, this program is {} and asks for {}: move {} "
                      "away, or name another directory with --out",
                      marker.string(), object.at("commit").dump(), object.at("question").dump(),
                      directory.environment().at("commit").dump(), to_json(question).dump(),
                      directory.path().string()));
    object.at("broken").get_to(corpus.broken);
  } catch (const json::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", marker.string(), error.what()));
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(place_of(directory)))
    if (entry.path().extension() == ".hdf5") corpus.files.push_back(entry.path());
  std::sort(corpus.files.begin(), corpus.files.end());
  return corpus;
}

void dump_corpus(const PaperDirectory& directory, const CorpusQuestion& question,
                 const std::function<void(const Progress&)>& progress,
                 const std::atomic<bool>& interrupted) {
  remove_all_of(unfinished_of(directory));
  remove_all_of(marker_of(directory));
  NamedScene scene = make_scene(question.scene);
  if (question.duration) scene.setup.duration = *question.duration;
  Progress state{.done = 0,
                 .total = static_cast<std::size_t>(
                     std::lround(scene.setup.duration / scene.setup.stepping.dt)),
                 .at = "corpus of " + question.scene};
  const ChildTask task = [&](const std::function<void()>& beat) {
    dump(directory, question, scene, beat);
  };
  run_children(
      {task}, 1, silence,
      [&](const ChildEnd& end) {
        if (!end.failure.empty())
          throw std::runtime_error(fmt::format("the corpus of {}, driven by {}: {}", question.scene,
                                               question.driver, end.failure));
      },
      [&](std::size_t) {
        ++state.done;
        progress(state);
      },
      interrupted);
}

}  // namespace lcp
