#include "problems/scenes/dump.h"

#include <fmt/format.h>

#include <filesystem>

#include "problems/io/errors.h"
#include "problems/io/hdf5/corpus.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr Index kFramesPerShard = 100;

}  // namespace

CorpusDump::CorpusDump(std::string directory, std::string scene, std::string driver)
    : directory_(std::move(directory)), scene_(std::move(scene)), driver_(std::move(driver)) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(directory_, error) &&
      !(fs::is_directory(directory_, error) && fs::is_empty(directory_, error)))
    throw UnwritableOutput("{}: exists already, expected a new directory for the corpus",
                           directory_);
  make_directories(directory_);
}

void CorpusDump::add(const Simulation& simulation, const Frame& frame) {
  if (frame.contacts.size() == 0) return;
  const FrictionModel& model = simulation.stepping().contact.friction;
  const std::string clean = simulation.is_composite_body() ? "composite body" : "joint space";
  if (simulation.stepping().matrix == Stepping::Matrix::clean) {
    add_pair(frame.contacts, frame, model, scene_, clean);
  } else {
    add_pair(frame.contacts, frame, model, scene_, "assembly and disassembly");
    add_pair(simulation.clean_contacts(frame), frame, model,
             scene_ + (simulation.is_composite_body() ? "+composite" : "+joint-space"), clean);
  }
  predecessor_ = fmt::format("{:05}", frame.number);
  if (++frames_in_shard_ == kFramesPerShard) write_shard();
}

void CorpusDump::add_pair(const ContactProblem& contacts, const Frame& frame,
                          const FrictionModel& model, const std::string& corpus,
                          const std::string& matrix) {
  std::map<std::string, std::string> provenance = {
      {"scene", scene_},
      {"time", fmt::format("{}", frame.state.time)},
      {"driver", driver_},
      {"predecessor", predecessor_ == "none" ? predecessor_ : corpus + "/" + predecessor_},
      {"applied", to_string(frame.solution.applied)},
      {"contact_ids", spell_ids(contacts.contacts)},
      {"W", matrix}};
  const auto add = [&](const std::string& name, const Problem& problem,
                       const std::optional<SolutionByContact>& before) {
    Instance instance =
        make_instance(fmt::format("{}/{:05}", name, frame.number), problem, provenance);
    instance.active_contacts = frame.solution.active;
    if (before)
      instance.previous =
          carried_over(*before, *problem.friction, contacts.contacts, problem.size());
    shard_.push_back(std::move(instance));
  };
  add(corpus, friction_lcp(contacts, model), frame.before.frictional);
  if (provenance["predecessor"] != "none")
    provenance["predecessor"] = corpus + "+frictionless/" + predecessor_;
  add(corpus + "+frictionless", frictionless_lcp(contacts), frame.before.frictionless);
}

void CorpusDump::write_shard() {
  write_corpus(fmt::format("{}/{:04}.hdf5", directory_, shards_), shard_);
  written_ += shard_.size();
  shard_.clear();
  frames_in_shard_ = 0;
  ++shards_;
}

void CorpusDump::close() {
  if (!shard_.empty()) write_shard();
}

}  // namespace lcp
