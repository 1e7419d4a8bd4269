#include "problems/scenes/dump.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "harness/studies/loop/in_the_loop.h"
#include "problems/io/errors.h"
#include "problems/io/load.h"
#include "tests/harness/temporary_directory.h"
#include "tests/problems/rigid/simulation_cases.h"

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

/// Takes three steps of a box on the ground with a link on a ball joint, which moves apart from it.
void dump_box_with_a_tail(const std::string& directory, Stepping::Matrix matrix) {
  const Vector3d edges(0.4, 0.3, 0.2);
  System system =
      cases::one_body(cases::free_box(2, edges),
                      cases::points_on_plane(cases::lower_corners(edges), Vector3d::UnitZ()), 0.5);
  cases::Uniform uniform(91);
  std::vector<Link> links = system.model.links();
  links.push_back(cases::random_link(0, JointKind::ball, uniform));
  system.model = Model(links);
  system.start = state_at_zero(system.model);
  system.start.q(2) = edges.z() / 2;
  Simulation simulation(system, {.matrix = matrix});
  CorpusDump dump(directory, "box", "best-first");
  for (int i = 0; i < 3; ++i)
    simulation.step(cases::solver_in_the_loop(),
                    [&](const Frame& frame) { dump.add(simulation, frame); });
  dump.close();
}

TEST(CorpusDump, WritesTheJointSpacesMatricesWhereLinksMoveApart) {
  TemporaryDirectory directory;
  dump_box_with_a_tail(directory.file("corpus"), Stepping::Matrix::ada);
  std::map<std::string, std::string> matrices;
  for (const Instance& instance : load_instances(directory.file("corpus")))
    if (instance.name.ends_with("/00002"))
      matrices[instance.name.substr(0, instance.name.find('/'))] = instance.provenance.at("W");
  const std::map<std::string, std::string> expected = {
      {"box", "assembly and disassembly"},
      {"box+frictionless", "assembly and disassembly"},
      {"box+joint-space", "joint space"},
      {"box+joint-space+frictionless", "joint space"}};
  EXPECT_EQ(matrices, expected);

  const std::string file = directory.file("corpus/0000.hdf5");
  const Instance ada = load_instances(file + "#box/00002").front();
  const Instance clean = load_instances(file + "#box+joint-space/00002").front();
  const MatrixXd &W = ada.problem.friction->W, &twin = clean.problem.friction->W;
  EXPECT_LT((W - twin).cwiseAbs().maxCoeff(), 1e-9 * twin.cwiseAbs().maxCoeff());
  EXPECT_NE(W, twin);
  EXPECT_EQ(twin, MatrixXd(twin.transpose()));
  EXPECT_EQ(clean.provenance.at("predecessor"), "box+joint-space/00001");
}

TEST(CorpusDump, OfASceneWithCleanMatricesHoldsNoOthers) {
  TemporaryDirectory directory;
  dump_box_with_a_tail(directory.file("corpus"), Stepping::Matrix::clean);
  for (const Instance& instance : load_instances(directory.file("corpus"))) {
    EXPECT_EQ(instance.provenance.at("W"), "joint space");
    EXPECT_EQ(instance.name.find("joint-space"), std::string::npos) << instance.name;
  }
  dump_squat(directory.file("squat"), 3, true, "squat:matrix=clean");
  for (const Instance& instance : load_instances(directory.file("squat")))
    EXPECT_EQ(instance.provenance.at("W"), "composite body");
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

TEST(CorpusDump, KeepsTheSolutionOfTheFrameBeforeThoughThatIsNotDumped) {
  TemporaryDirectory directory;
  NamedScene scene = make_scene("squat:points=8");
  scene.setup.duration = 6e-3;
  CorpusDump dump(directory.file("corpus"), scene.spelling, "best-first");
  std::map<std::string, VectorXd>
      found;  // in rows of the frame before, whose contacts are the same
  const std::atomic<bool> interrupted = false;
  run_in_the_loop(
      scene, make_solver("best-first"), {},
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord&) {
        if (frame.number == 1 || frame.number == 4) dump.add(simulation, frame);
        if (frame.number != 3) return;
        found["squat:points=8/00004"] = frame.solution.with_friction.z;
        found["squat:points=8+composite/00004"] = frame.solution.with_friction.z;
        found["squat:points=8+frictionless/00004"] = frame.solution.without_friction.z;
        found["squat:points=8+composite+frictionless/00004"] = frame.solution.without_friction.z;
      },
      interrupted);
  dump.close();
  Index checked = 0;
  for (const Instance& instance : load_instances(directory.file("corpus"))) {
    if (instance.name.ends_with("/00001")) {
      EXPECT_FALSE(instance.previous) << "nothing touched before";
      continue;
    }
    ASSERT_TRUE(instance.previous) << instance.name;
    EXPECT_EQ(instance.previous->z, found.at(instance.name)) << instance.name;
    EXPECT_FALSE(instance.previous->alpha.empty());
    ++checked;
  }
  EXPECT_EQ(checked, 4);
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
