#include "harness/measure/solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "harness/judge/judge.h"
#include "problems/contact/friction_lcp.h"

namespace lcp {
namespace {

VectorXd vec(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Index>(values.size()));
}

/// Answers as the test says; the islands are told apart by their size.
struct Scripted final : Solver {
  explicit Scripted(std::function<Result(Index n, const Call&)> script) {
    run = [script = std::move(script)](const Problem& problem, const Call& call) {
      return script(problem.size(), call);
    };
  }
};

Problem problem_of_size(Index n) {
  Problem problem;
  problem.M = MatrixXd::Identity(n, n);
  problem.q = VectorXd::Zero(n);
  set_plain_scales(problem);
  return problem;
}

/// Rows 0 and 2, and row 1, of a problem of size 3.
std::vector<Island> two_islands() {
  return {{problem_of_size(2), {0, 2}}, {problem_of_size(1), {1}}};
}

Result result_of(Claim claim, VectorXd z) {
  Result result;
  result.claim = claim;
  result.z = std::move(z);
  return result;
}

TEST(SolveIslands, ReturnsTheSolversResultAsItIsForOneIsland) {
  const Scripted solver([](Index, const Call&) {
    Result result = result_of(Claim::limit, vec({1, 2}));
    result.message = "as it is";
    result.z0 = 3;
    return result;
  });
  const Result whole = solve_islands(solver, {{problem_of_size(2), {0, 1}}}, 2);
  EXPECT_EQ(whole.claim, Claim::limit);
  EXPECT_EQ(whole.message, "as it is");
  EXPECT_EQ(whole.z0, 3);
  EXPECT_EQ(whole.z, vec({1, 2}));
}

TEST(SolveIslands, PutsTheAnswersBackIntoTheirRows) {
  const Scripted solver([](Index n, const Call&) {
    Result result = result_of(Claim::solved, n == 2 ? vec({10, 30}) : vec({20}));
    result.w = -result.z;
    result.basis = n == 2 ? std::vector<Index>{1} : std::vector<Index>{0};
    return result;
  });
  const Result whole = solve_islands(solver, two_islands(), 3);
  EXPECT_EQ(whole.claim, Claim::solved);
  EXPECT_EQ(whole.z, vec({10, 20, 30}));
  EXPECT_EQ(whole.w, vec({-10, -20, -30}));
  EXPECT_EQ(whole.basis, (std::vector<Index>{1, 2}));
  EXPECT_EQ(whole.covering.size(), 0);
}

TEST(SolveIslands, SumsTheWorkAndKeepsTheLargestQueue) {
  const Scripted solver([](Index n, const Call&) {
    Result result = result_of(Claim::solved, VectorXd::Zero(n));
    result.work.pivots = n;
    result.work.largest_queue = 10 * n;
    return result;
  });
  const Result whole = solve_islands(solver, two_islands(), 3);
  EXPECT_EQ(whole.work.pivots, 3);
  EXPECT_EQ(whole.work.largest_queue, 20);
}

TEST(SolveIslands, ClaimsWhatTheFirstFailingIslandClaims) {
  const Scripted solver([](Index n, const Call&) {
    Result result = result_of(n == 2 ? Claim::solved : Claim::infeasible, VectorXd::Zero(n));
    result.message = n == 2 ? "" : "no way";
    result.certificate = n == 2 ? VectorXd() : vec({7});
    return result;
  });
  const Result whole = solve_islands(solver, two_islands(), 3);
  EXPECT_EQ(whole.claim, Claim::infeasible);
  EXPECT_EQ(whole.message, "island 1: no way");
  EXPECT_EQ(whole.certificate, vec({0, 7, 0}));
}

TEST(SolveIslands, HasNoBasisUnlessEveryIslandHasOne) {
  const Scripted solver([](Index n, const Call&) {
    Result result = result_of(Claim::solved, VectorXd::Zero(n));
    if (n == 2) result.basis.emplace();
    return result;
  });
  EXPECT_FALSE(solve_islands(solver, two_islands(), 3).basis);
}

TEST(SolveIslands, KeepsEachIslandsShareOfTheArtificialVariable) {
  const Scripted solver([](Index n, const Call&) {
    Result result = result_of(Claim::ray, VectorXd::Zero(n));
    result.z0 = n == 2 ? 2 : 8;
    result.covering = VectorXd::Constant(n, 3);
    return result;
  });
  const Result whole = solve_islands(solver, two_islands(), 3);
  EXPECT_EQ(whole.z0, 8);
  EXPECT_EQ(whole.z0 * whole.covering, vec({6, 24, 6}));
}

TEST(SolveIslands, LeavesNoNumberWhereAnIslandReturnedNone) {
  const Scripted solver(
      [](Index n, const Call&) { return result_of(Claim::solved, n == 2 ? vec({1}) : vec({2})); });
  const Result whole = solve_islands(solver, two_islands(), 3);
  EXPECT_TRUE(std::isnan(whole.z(0)));
  EXPECT_EQ(whole.z(1), 2);
  EXPECT_TRUE(std::isnan(whole.z(2)));
}

TEST(SolveIslands, GivesEachIslandItsPartOfTheStart) {
  std::vector<std::vector<Index>> starts;
  const Scripted solver([&starts](Index n, const Call& call) {
    starts.push_back(call.start.value().alpha);
    return result_of(Claim::solved, VectorXd::Zero(n));
  });
  solve_islands(solver, two_islands(), 3, {.start = Start{{1, 2}}, .observer = {}});
  EXPECT_EQ(starts, (std::vector<std::vector<Index>>{{1}, {0}}));
}

TEST(SolveIslands, ShowsPivotsInTheNumbersOfTheWhole) {
  const Scripted solver([](Index n, const Call& call) {
    if (n == 2) {  // w_0 w_1 z_0 z_1 z0 are 0 ... 4.
      const std::vector<int> basic{0, 4};
      PivotEvent event;
      event.row = 1;
      event.entering = 4;
      event.leaving = 1;
      event.basic = &basic;
      call.observer(event);
    } else {
      const std::vector<int> basic{1};  // z_0
      PivotEvent event;
      event.entering = 1;
      event.basic = &basic;
      call.observer(event);
    }
    return result_of(Claim::solved, VectorXd::Zero(n));
  });
  std::vector<PivotEvent> events;
  std::vector<std::vector<int>> basics;
  Call call;
  call.observer = [&](const PivotEvent& event) {
    events.push_back(event);
    basics.push_back(*event.basic);
  };
  solve_islands(solver, two_islands(), 3, call);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].row, 2);
  EXPECT_EQ(events[0].entering, 6) << "z0";
  EXPECT_EQ(events[0].leaving, 2) << "w_2";
  EXPECT_EQ(basics[0], (std::vector<int>{0, 1, 6}));
  EXPECT_EQ(events[1].row, 1);
  EXPECT_EQ(events[1].entering, 4) << "z_1";
  EXPECT_EQ(basics[1], (std::vector<int>{0, 4, 6}));
}

/// Two particles that do not influence one another, W = I: each an island. n = mu_i > 0 ? 4 : 1.
Instance two_particles(const VectorXd& mu) {
  ContactProblem contacts;
  for (Index i = 0; i < 2; ++i)
    contacts.contacts.push_back(
        make_contact(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), mu(i), {i + 1, 0, 0}));
  contacts.W = MatrixXd::Identity(6, 6);
  contacts.vbar = vec({-1, 0.5, 0, -1, 0.5, 0});
  Instance instance;
  instance.problem = friction_lcp(contacts, {.directions = 2});
  return instance;
}

/// Notes size and start (or -1) of every solve: what is asked of it in which order.
struct Noting final : Solver {
  Noting() {
    run = [this, best_first = make_solver("best-first")](const Problem& problem, const Call& call) {
      asked.push_back({problem.size(), call.start ? Index(call.start->alpha.size()) : -1});
      return best_first.solver->solve(problem, call);
    };
  }
  Noting(const Noting&) = delete;
  Noting& operator=(const Noting&) = delete;

  std::vector<std::pair<Index, Index>> asked;
};

TEST(SolveInTwoSteps, SolvesEachIslandInTwoStepsByItself) {
  const Instance instance = two_particles(vec({0.2, 0.3}));
  const Noting solver;
  const Result whole = solve_instance(solver, instance, {}, StartKind::two_step);
  EXPECT_EQ(solver.asked, (std::vector<std::pair<Index, Index>>{{1, -1}, {4, 1}, {1, -1}, {4, 1}}));
  EXPECT_EQ(whole.claim, Claim::solved);
  EXPECT_EQ(whole.work.start_pivots, 2);
  EXPECT_EQ(whole.work.frictionless_pivots, 4) << "z0 in, z0 out, twice";
  EXPECT_EQ(judge(instance, whole, 1e-12).verdict, Verdict::solved);
}

TEST(SolveInTwoSteps, AnIslandWithoutFrictionBesideOthersIsSolvedOnce) {
  const Instance instance = two_particles(vec({0, 0.3}));
  const Noting solver;
  const Result whole = solve_instance(solver, instance, {}, StartKind::two_step);
  EXPECT_EQ(solver.asked, (std::vector<std::pair<Index, Index>>{{1, -1}, {1, -1}, {4, 1}}));
  EXPECT_EQ(judge(instance, whole, 1e-12).verdict, Verdict::solved);
}

TEST(SolveInTwoSteps, AnInstanceWithoutFrictionIsUnsupported) {
  Instance plain;
  plain.problem = problem_of_size(3);
  for (const Instance& instance : {two_particles(vec({0, 0})), plain}) {
    const Noting solver;
    const Result whole = solve_instance(solver, instance, {}, StartKind::two_step);
    EXPECT_TRUE(solver.asked.empty());
    EXPECT_EQ(judge(instance, whole, 1e-6).verdict, Verdict::unsupported);
    EXPECT_EQ(whole.message, "two-step: the instance has no friction");
    EXPECT_EQ(whole.z.size(), instance.problem.size());
  }
}

TEST(SolveInTwoSteps, RefusesAnotherStartBeside) {
  EXPECT_THROW(solve_instance(Noting(), two_particles(vec({0.2, 0.3})),
                              {.start = Start{{0}}, .observer = {}}, StartKind::two_step),
               std::invalid_argument);
}

/// Its cold solution by best-first, as if of the frame before.
Instance with_own_solution(Instance instance) {
  const Result solution = solve_instance(*make_solver("best-first").solver, instance);
  instance.previous = Start{.alpha = *solution.basis, .z = solution.z};
  return instance;
}

TEST(SolveFromPrevious, StartsEachIslandFromItsOwnRows) {
  const Instance instance = with_own_solution(two_particles(vec({0.2, 0.3})));
  std::vector<VectorXd> points;
  const Scripted looks([&](Index n, const Call& call) {
    points.push_back(call.start.value().z);
    EXPECT_EQ(call.start->alpha.front(), 0);
    return result_of(Claim::solved, VectorXd::Zero(n));
  });
  solve_instance(looks, instance, {}, StartKind::previous);
  ASSERT_EQ(points.size(), 2u);
  const std::vector<Island> islands = split_islands(instance.problem);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(points[k], VectorXd(instance.previous->z(islands[k].rows)));
  EXPECT_NE(points[0], points[1]) << "their friction differs";
}

TEST(SolveFromPrevious, NeedsNoPivotWhereNothingHasChanged) {
  const Instance instance = with_own_solution(two_particles(vec({0.2, 0.3})));
  for (const char* spelling : {"best-first", "best-first-lexicographic", "lexicographic-revised",
                               "lexicographic", "best-first-tableau"}) {
    const Result whole =
        solve_instance(*make_solver(spelling).solver, instance, {}, StartKind::previous);
    EXPECT_EQ(judge(instance, whole, 1e-12).verdict, Verdict::solved) << spelling;
    EXPECT_EQ(whole.work.pivots, 0) << spelling;
    EXPECT_EQ(whole.work.start_pivots, static_cast<Index>(instance.previous->alpha.size()));
    EXPECT_EQ(whole.work.restarts, 0);
    EXPECT_EQ(whole.message, "");
  }
  const Result swept = solve_instance(*make_solver("projected-gauss-seidel").solver, instance, {},
                                      StartKind::previous);
  EXPECT_EQ(swept.claim, Claim::solved);
  EXPECT_EQ(swept.work.sweeps, 0);
}

TEST(SolveFromPrevious, WithoutOneIsTheColdSolveAndCountsIt) {
  const Instance instance = two_particles(vec({0.2, 0.3}));
  for (const char* spelling : {"best-first", "lexicographic-revised", "projected-gauss-seidel"}) {
    const NamedSolver solver = make_solver(spelling);
    const Result cold = solve_instance(*solver.solver, instance);
    const Result whole = solve_instance(*solver.solver, instance, {}, StartKind::previous);
    EXPECT_EQ(whole.z, cold.z);
    EXPECT_EQ(whole.work.pivots, cold.work.pivots);
    EXPECT_EQ(whole.work.sweeps, cold.work.sweeps);
    EXPECT_EQ(whole.work.restarts, cold.work.restarts + 1);
    EXPECT_EQ(whole.message, "no previous solution; started cold");
  }
  const Scripted takes_none([](Index n, const Call& call) {
    return result_of(call.start ? Claim::unsupported : Claim::solved, VectorXd::Zero(n));
  });
  const Result refused = solve_instance(takes_none, instance, {}, StartKind::previous);
  EXPECT_EQ(refused.claim, Claim::unsupported);
  EXPECT_EQ(refused.work.restarts, 0);
}

TEST(SolveFromPrevious, ASingularBasisIsAResultAndMayBeReplaced) {
  Instance instance = two_particles(vec({0.2, 0.3}));
  instance.previous = Start{.alpha = {instance.problem.friction->cone_row[0]},
                            .z = VectorXd::Zero(instance.problem.size())};
  const Result whole =
      solve_instance(*make_solver("best-first").solver, instance, {}, StartKind::previous);
  EXPECT_EQ(whole.claim, Claim::singular);
  EXPECT_EQ(whole.message, "island 0: start not usable");
  const Result again = solve_instance(*make_solver("best-first:restart=cold").solver, instance, {},
                                      StartKind::previous);
  EXPECT_EQ(again.claim, Claim::solved);
  EXPECT_EQ(again.work.restarts, 1);
}

TEST(SolveFromPrevious, RefusesAnotherStartBeside) {
  EXPECT_THROW(solve_instance(Noting(), two_particles(vec({0.2, 0.3})),
                              {.start = Start{{0}}, .observer = {}}, StartKind::previous),
               std::invalid_argument);
}

TEST(StartKind, IsSpelledAsOnTheCommandLine) {
  for (const StartKind kind : all_values<StartKind>())
    EXPECT_EQ(from_string<StartKind>(to_string(kind)), kind);
  EXPECT_EQ(to_string(StartKind::two_step), "two-step");
  EXPECT_THROW(from_string<StartKind>("warm"), std::invalid_argument);
}

/// Two contacts without friction on bodies that do not influence one another.
TEST(SolveInstance, SolvesContactsThatDoNotInfluenceOneAnotherApart) {
  Instance instance;
  instance.problem = problem_of_size(2);
  FrictionBlocks blocks;
  blocks.W = MatrixXd::Identity(6, 6);
  blocks.vbar = VectorXd::Zero(6);
  blocks.mu = VectorXd::Zero(2);
  blocks.directions.resize(2, 0);
  blocks.normal_row = {0, 1};
  blocks.friction_row = {-1, -1};
  blocks.cone_row = {-1, -1};
  instance.problem.friction = blocks;
  const Scripted solver([](Index n, const Call&) {
    EXPECT_EQ(n, 1);
    return result_of(Claim::solved, vec({5}));
  });
  EXPECT_EQ(solve_instance(solver, instance).z, vec({5, 5}));
}

}  // namespace
}  // namespace lcp
