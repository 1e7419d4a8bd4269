#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"
#include "problems/rigid/simulation.h"

namespace lcp {

/// Writes the LCPs of a simulation as a corpus: a directory of files (shards) of 100 frames each,
/// which load_instances reads as one. A shard appears complete or not at all, so that whatever ends
/// the program, everything written so far is readable.
///
/// A frame with contact gives the frictional and the frictionless LCP, each with the contact matrix
/// of the ADA and with its clean twin (Simulation::clean_contacts), unless the scene is simulated
/// with that one: of the composite body where the system moves as one body, else of the joint
/// space.
///
///     SCENE/00042                SCENE+composite/00042                or SCENE+joint-space/00042
///     SCENE+frictionless/00042   SCENE+composite+frictionless/00042      ...
///
/// With each goes, as its `previous` (start kind `previous`), the solution that the driver found for
/// the frame before, dumped or not, carried over by contact (carried_over): the frictional one, or
/// for the frictionless LCP the frictionless one. There is none where that frame had no contact or
/// its solution was not accepted. A clean twin gets the same, found with the scene's own matrix.
///
/// Provenance: scene, time, driver, predecessor, applied, contact_ids, W ("assembly and
/// disassembly", "composite body" or "joint space").
class CorpusDump {
 public:
  /// `scene` and `driver` in full spelling. Throws UnwritableOutput when `directory` exists and is
  /// not empty, or cannot be made.
  CorpusDump(std::string directory, std::string scene, std::string driver);
  /// Throws UnwritableOutput.
  void add(const Simulation& simulation, const Frame& frame);
  /// Writes the last shard. A dump that is destroyed without this lacks the frames in it.
  void close();

  std::size_t instances() const { return written_; }

 private:
  void add_pair(const ContactProblem& contacts, const Frame& frame, const FrictionModel& model,
                const std::string& corpus, const std::string& matrix);
  void write_shard();

  std::string directory_, scene_, driver_;
  std::vector<Instance> shard_;
  Index frames_in_shard_ = 0, shards_ = 0;
  std::size_t written_ = 0;
  std::string predecessor_ = "none";
};

}  // namespace lcp
