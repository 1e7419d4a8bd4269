#include "harness/measure/worker.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <vector>

#include "harness/measure/wire.h"

namespace lcp {
namespace {

using namespace std::chrono_literals;
using How = Outcome::How;

constexpr Limits generous{60s, std::int64_t{1} << 30};

Outcome await(Worker& worker) {
  for (;;) {
    if (std::optional<Outcome> outcome = worker.check()) return *outcome;
    std::vector<pollfd> watched = worker.watched();
    poll(watched.data(), watched.size(), 5);
  }
}

Outcome ask_once(const std::function<Result()>& solve, const Limits& limits = generous) {
  Worker worker(solve, limits);
  worker.ask();
  return await(worker);
}

Result full_result() {
  Result result;
  result.claim = Claim::infeasible;
  result.message = "a message";
  result.z = VectorXd::LinSpaced(3, 0.1, 1.0 / 3);
  result.w = VectorXd::Constant(3, -0.0);
  result.z0 = std::numeric_limits<double>::infinity();
  result.covering = VectorXd::Constant(3, std::numeric_limits<double>::quiet_NaN());
  result.basis = {0, 2};
  result.certificate = VectorXd::Constant(3, std::numeric_limits<double>::denorm_min());
  result.work.pivots = 12;
  result.work.restarts = 1;
  result.work.frictionless_pivots = 7;
  return result;
}

TEST(Wire, KeepsEveryField) {
  const Result result = full_result();
  const Result back = decode(encode(result));
  EXPECT_EQ(back.claim, result.claim);
  EXPECT_EQ(back.message, result.message);
  EXPECT_EQ(back.z, result.z);
  EXPECT_TRUE(back.w.size() == 3 && std::signbit(back.w(1)));
  EXPECT_EQ(back.z0, result.z0);
  EXPECT_TRUE(back.covering.size() == 3 && back.covering.array().isNaN().all());
  EXPECT_EQ(back.basis, result.basis);
  EXPECT_EQ(back.certificate, result.certificate);
  EXPECT_EQ(back.work.pivots, 12);
  EXPECT_EQ(back.work.restarts, 1);
  EXPECT_EQ(back.work.frictionless_pivots, 7);
  EXPECT_EQ(decode(encode(Result{})).basis, std::nullopt);
}

TEST(Wire, TellsResultsApartByTheirLastBit) {
  Result result = full_result();
  const std::string bytes = encode(result);
  EXPECT_EQ(encode(full_result()), bytes);
  result.z(1) = std::nextafter(result.z(1), 1);
  EXPECT_NE(encode(result), bytes);
}

TEST(Wire, RefusesBytesThatAreNoResult) {
  EXPECT_ANY_THROW(decode(""));
  EXPECT_ANY_THROW(decode(encode(full_result()).substr(0, 40)));
}

TEST(Worker, AnswersAsOftenAsItIsAsked) {
  Worker worker([] { return full_result(); }, generous);
  for (int call = 1; call <= 3; ++call) {
    worker.ask();
    const Outcome outcome = await(worker);
    EXPECT_EQ(outcome.how, How::answered);
    EXPECT_EQ(outcome.result.work.pivots, full_result().work.pivots);
    EXPECT_GE(outcome.time_ns, 0);
  }
}

/// The number of the solve behind each of three answers.
std::vector<Index> solves_behind_answers(std::chrono::nanoseconds warm_up_below) {
  Limits limits = generous;
  limits.warm_up_below = warm_up_below;
  Worker worker(
      [calls = 0]() mutable {
        Result result = full_result();
        result.work.pivots = ++calls;
        return result;
      },
      limits);
  std::vector<Index> solves;
  for (int answer = 0; answer < 3; ++answer) {
    worker.ask();
    solves.push_back(await(worker).result.work.pivots);
  }
  return solves;
}

TEST(Worker, TimesAShortSolveRightAfterAnotherWhoseOtherAnswerIsTheOneItGives) {
  EXPECT_EQ(solves_behind_answers(1h), (std::vector<Index>{1, 2, 4}));
}

TEST(Worker, SolvesOnceWhereThatTakesLong) {
  EXPECT_EQ(solves_behind_answers(0s), (std::vector<Index>{1, 2, 3}));
}

TEST(Worker, BringsBackAnswersLargerThanASocketsBuffer) {
  const VectorXd large = VectorXd::Random(200'000);
  const Outcome outcome = ask_once([&large] {
    Result result;
    result.z = large;
    return result;
  });
  EXPECT_EQ(outcome.result.z, large);
}

TEST(Worker, ReportsExceptionsWithTheirText) {
  const Outcome outcome = ask_once([]() -> Result { throw std::runtime_error("so there"); });
  EXPECT_EQ(outcome.how, How::threw);
  EXPECT_EQ(outcome.message, "so there");
  EXPECT_EQ(outcome.exit_signal, 0);
  EXPECT_EQ(ask_once([]() -> Result { throw 1; }).how, How::threw);
}

TEST(Worker, ReportsHowItDied) {
  const Outcome killed = ask_once([]() -> Result { std::abort(); });
  EXPECT_EQ(killed.how, How::died);
  EXPECT_EQ(killed.exit_signal, SIGABRT);
  const Outcome left = ask_once([]() -> Result { _exit(3); });
  EXPECT_EQ(left.how, How::died);
  EXPECT_EQ(left.exit_signal, 0);
  EXPECT_EQ(left.message, "exited with status 3");
}

TEST(Worker, IsKilledAtItsTimeLimit) {
  const Outcome outcome = ask_once(
      []() -> Result {
        for (;;) pause();
      },
      {200ms, 1 << 30});
  EXPECT_EQ(outcome.how, How::timed_out);
  EXPECT_EQ(outcome.exit_signal, SIGKILL);
  EXPECT_GE(outcome.time_ns, std::chrono::nanoseconds(200ms).count());
}

TEST(Worker, IsKilledAtItsTimeLimitHoweverMuchItPrints) {
  Worker worker(
      []() -> Result {
        for (;;) std::puts("still here");
      },
      {200ms, 1 << 30});
  worker.ask();
  EXPECT_EQ(await(worker).how, How::timed_out);
  EXPECT_NE(worker.output_end().find("still here\n"), std::string::npos);
}

TEST(Worker, HasAProcessGroupOfItsOwnAndAnEmptyInput) {
  const Outcome outcome = ask_once([] {
    Result result;
    result.work.pivots = getpgrp() == getpid();
    result.work.nodes = std::getchar() == EOF;
    return result;
  });
  EXPECT_EQ(outcome.result.work.pivots, 1);
  EXPECT_EQ(outcome.result.work.nodes, 1);
}

/// The test adopts the worker of a child that is killed, so that it can see how the worker ends.
TEST(Worker, DiesWithItsParent) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    Worker worker(
        [calls = 0]() mutable -> Result {
          // Survives its parent at most so long, and then exits with status 0.
          if (calls++ > 0) sleep(30);
          return {};
        },
        generous);
    worker.ask();
    await(worker);  // Now it has surely started.
    worker.ask();
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(parent, &status, 0), parent);
  ASSERT_GT(waitpid(-1, &status, 0), 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace lcp
