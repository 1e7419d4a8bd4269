#include "problems/contact/frame_series.h"

#include <gtest/gtest.h>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

/// A contact whose friction pushes back on its normal, so that one sweep does not settle it.
ContactProblem coupled_contact() {
  ContactProblem problem = cases::particle(0.5, {-1, 0.3, 0});
  problem.W(0, 1) = problem.W(1, 0) = 0.2;
  return problem;
}

TEST(FrameSeries, AppliesTheForcesOfTheFrictionalProblem) {
  FrameSeries series("scene", "best-first", {});
  const VectorXd forces = series.add(cases::particle(0.5, {-1, 0.3, 0}), 0.25, "dropped");
  EXPECT_NEAR((forces - Eigen::Vector3d(2, -0.6, 0)).norm(), 0, 1e-14);
  series.add(coupled_contact(), 0.5, "");
  const std::vector<Instance> frames = series.take();
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].name, "scene/0000");
  EXPECT_EQ(frames[0].provenance.at("driver"), "best-first");
  EXPECT_EQ(frames[0].provenance.at("time"), "0.25");
  EXPECT_EQ(frames[0].provenance.at("start"), "dropped");
  EXPECT_EQ(frames[0].provenance.at("predecessor"), "none");
  EXPECT_EQ(frames[0].provenance.at("applied"), "frictional");
  EXPECT_EQ(frames[0].provenance.at("contact_ids"), "1-0-0");
  EXPECT_EQ(frames[1].provenance.at("predecessor"), "scene/0000");
  EXPECT_EQ(frames[1].provenance.at("start"), "forces of scene/0000");
  EXPECT_EQ(frames[1].provenance.at("fallbacks"), "0");
}

TEST(FrameSeries, KeepsTheSolutionOfTheFrameBefore) {
  FrameSeries series("scene", "best-first", {});
  series.add(coupled_contact(), 0, "dropped");
  series.add(coupled_contact(), 1, "shaken");
  const std::vector<Instance> frames = series.take();
  EXPECT_FALSE(frames[0].previous);
  ASSERT_TRUE(frames[1].previous);
  const Result solution = make_solver("best-first").solver->solve(frames[0].problem);
  EXPECT_EQ(frames[1].previous->alpha, solution.basis);
  EXPECT_EQ(frames[1].previous->z, solution.z);
  EXPECT_EQ(frames[0].sha256, frames[1].sha256) << "it is no part of the content";

  FrameSeries unsolved("scene", "projected-gauss-seidel:max_sweeps=1", {});
  unsolved.add(coupled_contact(), 0, "");
  unsolved.add(coupled_contact(), 1, "");
  EXPECT_FALSE(unsolved.take()[1].previous);
}

TEST(FrameSeries, CountsTheContactsActiveWithoutFriction) {
  FrameSeries series("scene", "best-first", {});
  ContactProblem pair;
  pair.contacts = cases::floor_contacts({0.5, 0.5});
  pair.W = MatrixXd::Identity(6, 6);
  pair.vbar = VectorXd{{-1, 0, 0, 2, 0, 0}};  // one falls, the other leaves
  series.add(pair, 0, "");
  EXPECT_EQ(series.take().front().active_contacts, 1);
}

TEST(FrameSeries, FallsBackOnTheFrictionlessProblemAndCountsIt) {
  FrameSeries series("scene", "projected-gauss-seidel:max_sweeps=1", {});
  const VectorXd forces = series.add(coupled_contact(), 0, "");
  EXPECT_EQ(forces, Eigen::Vector3d(2, 0, 0));
  const Instance frame = series.take().front();
  EXPECT_EQ(frame.provenance.at("applied"), "frictionless");
  EXPECT_EQ(frame.provenance.at("fallbacks"), "1");
  EXPECT_FALSE(frame.active_contacts);  // the driver has no basis
}

TEST(FrameSeries, AppliesNothingWhereTheDriverFailsTwice) {
  FrameSeries series("scene", "projected-gauss-seidel", {});
  ContactProblem immovable = cases::particle(0.5, {-1, 0.3, 0});
  immovable.W.setZero();
  EXPECT_EQ(series.add(immovable, 0, ""), Eigen::Vector3d::Zero());
  EXPECT_EQ(series.take().front().provenance.at("applied"), "none");
}

TEST(LoneFrame, HasNoPredecessorAndKnowsItsActiveContacts) {
  ContactProblem pair;
  pair.contacts = cases::floor_contacts({0.5, 0.5});
  pair.W = MatrixXd::Identity(6, 6);
  pair.vbar = VectorXd{{-1, 0, 0, 2, 0, 0}};  // one falls, the other leaves
  const Instance frame = lone_frame("scene", 7, pair, {.directions = 4}, make_solver("best-first"),
                                    {{"points_found", "9"}});
  EXPECT_EQ(frame.name, "scene/0007");
  EXPECT_EQ(frame.problem.size(), 12);
  EXPECT_EQ(frame.active_contacts, 1);
  EXPECT_EQ(frame.provenance, (std::map<std::string, std::string>{{"scene", "scene"},
                                                                  {"driver", "best-first"},
                                                                  {"contact_ids", "1-0-0 1-0-1"},
                                                                  {"points_found", "9"}}));
}

TEST(FrameSeries, RefusesAnUnknownDriver) {
  EXPECT_THROW(FrameSeries("scene", "nobody", {}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
