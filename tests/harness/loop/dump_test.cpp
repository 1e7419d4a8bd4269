#include "problems/scenes/dump.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "harness/loop/in_the_loop.h"
#include "problems/io/errors.h"
#include "problems/io/load.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

/// Simulates the squat for `steps` ms and dumps it; without `close` as if killed before the end.
void dump_squat(const std::string& directory, Index steps, bool close,
                const std::string& scene_text = "squat:points=8") {
  NamedScene scene = make_scene(scene_text);
  scene.setup.duration = 1e-3 * static_cast<double>(steps);
  CorpusDump dump(directory, scene.spelling, "best-first");
  const std::atomic<bool> interrupted = false;
  run_in_the_loop(
      scene, make_solver("best-first"), {},
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord&) {
        dump.add(simulation, frame);
      },
      interrupted);
  if (close) dump.close();
}

TEST(CorpusDump, HoldsBothLcpsOfEveryFrameWithContactWithBothMatrices) {
  TemporaryDirectory directory;
  dump_squat(directory.file("corpus"), 10, true);
  std::map<std::string, int> corpora;
  for (const Instance& instance : load_instances(directory.file("corpus"))) {
    ++corpora[instance.name.substr(0, instance.name.find('/'))];
    EXPECT_EQ(instance.provenance.at("scene"), "squat:points=8");
    EXPECT_EQ(instance.provenance.at("driver"), "best-first");
    EXPECT_EQ(instance.provenance.at("applied"), "frictional");
    EXPECT_TRUE(instance.active_contacts.has_value());
  }
  const std::map<std::string, int> expected = {{"squat:points=8", 9},
                                               {"squat:points=8+composite", 9},
                                               {"squat:points=8+composite+frictionless", 9},
                                               {"squat:points=8+frictionless", 9}};
  EXPECT_EQ(corpora, expected) << "the first frame touches nothing";
}

TEST(CorpusDump, TheMatricesDifferByNoiseAlone) {
  TemporaryDirectory directory;
  dump_squat(directory.file("corpus"), 10, true);
  const std::string file = directory.file("corpus/0000.hdf5");
  const Instance ada = load_instances(file + "#squat:points=8/00009").front();
  const Instance composite = load_instances(file + "#squat:points=8+composite/00009").front();
  EXPECT_EQ(ada.provenance.at("W"), "assembly and disassembly");
  EXPECT_EQ(composite.provenance.at("W"), "composite body");
  const MatrixXd &W = ada.problem.friction->W, &clean = composite.problem.friction->W;
  EXPECT_LT((W - clean).cwiseAbs().maxCoeff(), 1e-9 * clean.cwiseAbs().maxCoeff());
  EXPECT_NE(W, clean);
}

TEST(CorpusDump, NamesThePredecessor) {
  TemporaryDirectory directory;
  dump_squat(directory.file("corpus"), 10, true);
  const std::string file = directory.file("corpus/0000.hdf5");
  EXPECT_EQ(load_instances(file + "#squat:points=8/00009").front().provenance.at("predecessor"),
            "squat:points=8/00008");
  EXPECT_EQ(load_instances(file + "#squat:points=8+frictionless/00009")
                .front()
                .provenance.at("predecessor"),
            "squat:points=8+frictionless/00008");
  EXPECT_EQ(load_instances(file + "#squat:points=8/00001").front().provenance.at("predecessor"),
            "none");
}

TEST(CorpusDump, WithoutItsEndIsReadableUpToTheLastClosedShard) {
  TemporaryDirectory directory;
  dump_squat(directory.file("corpus"), 115, false);
  Index frames = 0;
  for (const Instance& instance : load_instances(directory.file("corpus")))
    frames += instance.name.starts_with("squat:points=8/");
  EXPECT_EQ(frames, 100) << "one shard of two";
}

TEST(CorpusDump, RefusesADirectoryThatHoldsSomething) {
  TemporaryDirectory directory;
  write_text(directory.file("file"), "");
  EXPECT_THROW(CorpusDump(directory.path(), "squat", "best-first"), UnwritableOutput);
  EXPECT_THROW(CorpusDump(directory.file("file"), "squat", "best-first"), UnwritableOutput);
  EXPECT_THROW(CorpusDump(directory.file("file/below"), "squat", "best-first"), UnwritableOutput);
}

}  // namespace
}  // namespace lcp
