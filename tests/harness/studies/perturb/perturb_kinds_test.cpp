#include "harness/studies/perturb/perturb_kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "harness/studies/perturb/perturb_plan.h"
#include "problems/contact/friction_lcp.h"
#include "problems/registry.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Instance instance_of(const std::string& family, Index place = 1) {
  return generate(family, {.count = place + 1, .seed = 1}).back();
}

/// Entries differ by at most `most` times their size.
void expect_near(const MatrixXd& one, const MatrixXd& two, double most, const char* what) {
  ASSERT_EQ(one.rows(), two.rows()) << what;
  ASSERT_EQ(one.cols(), two.cols()) << what;
  for (Index j = 0; j < one.cols(); ++j)
    for (Index i = 0; i < one.rows(); ++i)
      ASSERT_NEAR(one(i, j), two(i, j), most * std::abs(two(i, j)))
          << what << " at " << i << ", " << j;
}

double residual(const Instance& instance, const VectorXd& z) {
  Result result;
  result.claim = Claim::solved;
  result.z = z;
  return measure(instance.problem, result).residual;
}

class OnAFamily : public testing::TestWithParam<const char*> {
 protected:
  const Instance instance_ = instance_of(GetParam());
};

TEST_P(OnAFamily, AnswersOfDisturbedProblemsSolveTheOriginal) {
  const NamedSolver solver = make_solver("best-first");
  const std::vector<Disturbance> all = disturbances_of(instance_, {});
  ASSERT_GE(all.size(), 5u + 5u + 3u + 5u);
  for (const Disturbance& each : all) {
    const Disturbed disturbed = disturb(instance_, each, {});
    EXPECT_EQ(disturbed.instance.name, instance_.name + "~" + each.label);
    EXPECT_NE(disturbed.instance.sha256, instance_.sha256) << each.label;
    const Result result = solve_instance(*solver.solver, disturbed.instance);
    ASSERT_EQ(judge(disturbed.instance, result, 1e-6).verdict, Verdict::solved) << each.label;
    EXPECT_LE(residual(instance_, disturbed.back(result.z)), 1e-11) << each.label;
  }
}

TEST_P(OnAFamily, WhatIsKnownOfSolutionsGoesAlong) {
  Instance known = instance_;
  const Result result = solve_instance(*make_solver("best-first").solver, known);
  known.known_solution = result.z;
  known.previous = Start{*result.basis, result.z};
  for (const Disturbance& each : disturbances_of(known, {})) {
    const Disturbed disturbed = disturb(known, each, {});
    const Start& start = disturbed.instance.previous.value();
    EXPECT_LE(residual(disturbed.instance, disturbed.instance.known_solution.value()), 1e-11)
        << each.label;
    expect_near(disturbed.back(start.z), result.z, 4 * epsilon, each.label.c_str());
    const Result warm = solve_instance(*make_solver("best-first").solver, disturbed.instance, {},
                                       StartKind::previous);
    EXPECT_EQ(judge(disturbed.instance, warm, 1e-6).verdict, Verdict::solved) << each.label;
    EXPECT_EQ(warm.work.pivots, 0) << each.label << ": " << warm.message;
  }
}

TEST_P(OnAFamily, ThePermutationOfAPermutationsInverseIsTheOriginalBitForBit) {
  Random random(7);
  const Order order = random_order(instance_.problem, random);
  const Disturbed there = permuted(instance_, order, "there");
  const Disturbed back = permuted(there.instance, inverse(order), "back");
  EXPECT_NE(there.instance.sha256, instance_.sha256);
  Instance same_name = back.instance;
  same_name.name = instance_.name;
  same_name.provenance = instance_.provenance;
  same_name.known_solution = instance_.known_solution;
  expect_same(same_name, instance_);
}

TEST_P(OnAFamily, UnitsThereAndBackAreTheOriginalUpToRounding) {
  const Units units{.length = 1e3, .force = 1e-3};
  const Disturbed there = in_units(instance_, units, "there");
  const Problem back =
      in_units(there.instance, {1 / units.length, 1 / units.force}, "back").instance.problem;
  const double least = 8 * epsilon * instance_.problem.M.cwiseAbs().maxCoeff();
  EXPECT_LE((back.M - instance_.problem.M).cwiseAbs().maxCoeff(), least);
  expect_near(back.s_z, instance_.problem.s_z, 8 * epsilon, "s_z");
  expect_near(back.s_w, instance_.problem.s_w, 8 * epsilon, "s_w");
  EXPECT_LE((back.q - instance_.problem.q).cwiseAbs().maxCoeff(),
            8 * epsilon * instance_.problem.q.cwiseAbs().maxCoeff());
}

TEST_P(OnAFamily, NoiseMovesLastBitsAlone) {
  Random random(3);
  const Problem noisy = with_noise(instance_, 1, random, "noise").instance.problem;
  const MatrixXd& M =
      instance_.problem.friction ? instance_.problem.friction->W : instance_.problem.M;
  const MatrixXd& moved = noisy.friction ? noisy.friction->W : noisy.M;
  expect_near(moved, M, 2 * epsilon, "M or W");  // So zeros stay zeros.
  EXPECT_NE(moved, M);
  EXPECT_EQ(M == M.transpose(), moved == moved.transpose());
  EXPECT_EQ(reason_against_reassembly(noisy), "");
}

TEST_P(OnAFamily, MillimetresChangeNumbersAndScalesAlike) {
  const Problem& metres = instance_.problem;
  const Problem mm = in_units(instance_, {.length = 1000}, "mm").instance.problem;
  for (Index i = 0; i < metres.size(); ++i) {
    const bool cone = metres.friction && std::count(metres.friction->cone_row.begin(),
                                                    metres.friction->cone_row.end(), i) > 0;
    EXPECT_NEAR(mm.s_w(i) / metres.s_w(i), cone ? 1 : 1000, 1e-10) << i;
    EXPECT_NEAR(mm.s_z(i) / metres.s_z(i), cone ? 1000 : 1, 1e-10) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, OnAFamily,
                         testing::Values("squat-like:contacts=6", "stack:bodies=2,mass_ratio=1",
                                         "draped-chain:links=8,wrapped=4", "random-p:n=12",
                                         "random-p:n=12,skew=0"),
                         [](const auto& family) {
                           std::string name = family.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); },
                               '_');
                           return name;
                         });

TEST(Disturbances, ConstantsOfAContactLcpStayExactUnderNoise) {
  const Instance instance = instance_of("squat-like:contacts=4");
  Random random(1);
  const Problem noisy = with_noise(instance, 1, random, "noise").instance.problem;
  const FrictionBlocks& blocks = *noisy.friction;
  const Index m = blocks.directions_per_contact;
  for (Index i = 0; i < blocks.contacts(); ++i) {
    const Index cone = blocks.cone_row[i], first = blocks.friction_row[i];
    EXPECT_EQ(noisy.M(cone, blocks.normal_row[i]), blocks.mu(i));
    EXPECT_TRUE((noisy.M.row(cone).segment(first, m).array() == -1).all());
    EXPECT_TRUE((noisy.M.col(cone).segment(first, m).array() == 1).all());
    for (Index k = 0; k < m / 2; ++k)  // Opposite directions stay opposite, to the bit.
      EXPECT_EQ(noisy.q(first + k), -noisy.q(first + k + m / 2));
  }
}

TEST(Disturbances, AFullTurnIsNoTurn) {
  const Instance instance = instance_of("squat-like:contacts=4");
  const Index m = instance.problem.friction->directions_per_contact;
  const Disturbed turned = turned_by_steps(instance, {m, 0, -m, 2 * m}, "turned");
  expect_same_bits(turned.instance.problem.M, instance.problem.M, "M");
}

TEST(Disturbances, TurnedAxesGiveTheSameMatrixUnderOtherLabels) {
  const Instance instance = instance_of("squat-like:contacts=4");
  const Disturbed turned = turned_by_steps(instance, {1, 3, 5, 0}, "turned");
  const Index n = instance.problem.size();
  VectorXd labels(n);
  for (Index j = 0; j < n; ++j) labels(j) = static_cast<double>(j);
  const VectorXd moved = turned.back(labels);  // moved(i): row of the turned problem that is row i
  EXPECT_NE(moved, labels);
  std::vector<Index> rows;
  for (const double row : moved) rows.push_back(static_cast<Index>(row));
  const MatrixXd again = turned.instance.problem.M(rows, rows);
  EXPECT_LE((again - instance.problem.M).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NE(turned.instance.problem.friction->W, instance.problem.friction->W);
}

TEST(Disturbances, AnyAngleMapsBackToTheSameForces) {
  const Instance instance = instance_of("squat-like:contacts=4");
  const VectorXd angles = VectorXd::LinSpaced(4, 0.1, 3);
  const Disturbed turned = turned_by_angles(instance, angles, "turned");
  const Result result = solve_instance(*make_solver("best-first").solver, turned.instance);
  ASSERT_EQ(result.claim, Claim::solved);
  const VectorXd there = contact_forces(*turned.instance.problem.friction, result.z);
  const VectorXd z = turned.back(result.z);
  const VectorXd here = contact_forces(*instance.problem.friction, z);
  EXPECT_GE(z.minCoeff(), 0);
  double tangential = 0;
  for (Index i = 0; i < 4; ++i) {
    const Eigen::Rotation2Dd turn(angles(i));
    EXPECT_LE((here.segment<2>(3 * i + 1) - turn * there.segment<2>(3 * i + 1)).norm(),
              1e-12 * there.norm());
    EXPECT_EQ(here(3 * i), there(3 * i));
    tangential = std::max(tangential, here.segment<2>(3 * i + 1).norm());
  }
  EXPECT_GT(tangential, 1e-6 * there.norm()) << "nothing was turned";
}

TEST(Disturbances, AreRefusedWithTheReasonWhereTheyDoNotApply) {
  Instance instance = instance_of("squat-like:contacts=4");
  Random random(1);
  EXPECT_EQ(reason_against_reassembly(instance.problem), "");
  instance.problem.M(0, 0) *= 1 + 1e-9;
  EXPECT_EQ(reason_against_reassembly(instance.problem),
            "M and q are not those of its friction blocks");
  EXPECT_THROW(with_noise(instance, 1, random, "x"), std::invalid_argument);
  for (const Disturbance& each : disturbances_of(instance, {}))
    EXPECT_EQ(each.kind, DisturbanceKind::permutation) << each.label;

  const Instance plain = instance_of("random-p:n=6");
  EXPECT_EQ(reason_against_turning(plain.problem), "no contact has friction");
  EXPECT_THROW(turned_by_steps(plain, {}, "x"), std::invalid_argument);

  Instance bent = instance_of("squat-like:contacts=4");
  bent.problem.friction->directions.col(0) = bent.problem.friction->directions.col(1);
  EXPECT_EQ(reason_against_turning(bent.problem), "the friction directions are no regular polygon");
}

TEST(Disturbances, ScalesOfTheInstancesOwnAreKeptInTheNewUnits) {
  Instance instance = instance_of("random-p:n=6");
  instance.problem.s_z *= 3;
  const Problem mm = in_units(instance, {.length = 1000}, "mm").instance.problem;
  expect_same_bits(mm.s_z, instance.problem.s_z, "s_z");
  expect_same_bits(mm.s_w, 1000 * instance.problem.s_w, "s_w");
}

TEST(Disturbances, DependOnSeedAndNameAlone) {
  const std::vector<Instance> two = generate("random-p:n=6", {.count = 2, .seed = 1});
  const std::vector<Disturbance> all = disturbances_of(two[0], {});
  PerturbOptions other_seed;
  other_seed.seed = 2;
  Instance renamed = two[0];
  renamed.name = "random-p/else";
  const auto hash = [&](const Instance& instance, std::size_t k, const PerturbOptions& options) {
    return disturb(instance, all[k], options).instance.sha256;
  };
  EXPECT_EQ(hash(two[0], 0, {}), hash(two[0], 0, {}));
  EXPECT_NE(hash(two[0], 0, {}), hash(two[0], 1, {}));
  EXPECT_NE(hash(two[0], 0, {}), hash(two[0], 0, other_seed));
  EXPECT_NE(hash(two[0], 0, {}), hash(renamed, 0, {}));
}

TEST(Disturbances, ThereAreNoMoreUnitsAndPowersThanThereAre) {
  PerturbOptions options;
  options.trials = 40;
  options.kinds = {DisturbanceKind::units, DisturbanceKind::scale_q};
  const std::vector<Disturbance> all = disturbances_of(instance_of("random-p:n=6"), options);
  ASSERT_EQ(all.size(), 15u);
  std::set<std::string> labels;
  for (const Disturbance& each : all) labels.insert(each.label);
  EXPECT_EQ(labels.size(), 15u);
  EXPECT_TRUE(labels.contains("units-mm") && labels.contains("scale-q-1e-6"));
}

}  // namespace
}  // namespace lcp
