#include "harness/measure/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "harness/judge/judge.h"
#include "harness/measure/worker.h"
#include "harness/observed_quantile.h"

namespace lcp {

namespace {

constexpr int tick_ms = 10;  // Between looks at the limits and at `interrupted`.
constexpr std::size_t fewest_samples = 3;
constexpr std::int64_t longest_warm_up_ns = 1'000'000'000;

void require(bool holds, const std::string& complaint) {
  if (!holds) throw std::invalid_argument("run: " + complaint);
}

void check_plan(const RunPlan& plan) {
  require(plan.tolerance >= 0, fmt::format("tolerance is {}, expected 0 or more", plan.tolerance));
  require(plan.timeout.count() > 0,
          fmt::format("timeout is {} ns, expected more than 0", plan.timeout.count()));
  require(plan.memory_bytes > 0,
          fmt::format("memory limit is {} bytes, expected more than 0", plan.memory_bytes));
  require(!plan.starts.empty(), "no start, expected one or more");
  require(plan.jobs >= 1, fmt::format("jobs is {}, expected 1 or more", plan.jobs));
  require(plan.max_samples >= 1,
          fmt::format("max_samples is {}, expected 1 or more", plan.max_samples));
  require(plan.spread >= 0, fmt::format("spread is {}, expected 0 or more", plan.spread));
  require(plan.shard.index >= 0 && plan.shard.index < plan.shard.count,
          fmt::format("shard is {} of {}, expected 0 ... {}", plan.shard.index, plan.shard.count,
                      plan.shard.count - 1));
  for (const Instance& instance : plan.instances) check(instance.problem, instance.name);
}

/// A solver from one of the starts.
struct Entrant {
  const NamedSolver* solver;
  StartKind start;
};

/// Hash of what the results from this start depend on.
std::string hash_of(const Instance& instance, StartKind start) {
  return start == StartKind::previous ? hash_with_previous(instance) : instance.sha256;
}

PairKey key_of(const Instance& instance, const Entrant& entrant) {
  return {instance.name, hash_of(instance, entrant.start), entrant.solver->spelling,
          to_string(entrant.start)};
}

/// Those that are to meet on one instance.
struct Fixture {
  const Instance& instance;
  Index place;
  std::vector<Entrant> entrants;
};

/// What of the plan is to be run: its shard, without the pairs done.
std::vector<Fixture> open_fixtures(const RunPlan& plan) {
  std::vector<Fixture> fixtures;
  for (std::size_t k = plan.shard.index; k < plan.instances.size(); k += plan.shard.count) {
    Fixture fixture{plan.instances[k], plan.first_place + static_cast<Index>(k), {}};
    for (const NamedSolver& solver : plan.solvers)
      for (const StartKind start : plan.starts)
        if (!plan.done.contains(key_of(fixture.instance, {&solver, start})))
          fixture.entrants.push_back({&solver, start});
    if (!fixture.entrants.empty()) fixtures.push_back(std::move(fixture));
  }
  return fixtures;
}

std::size_t pairs_of(const std::vector<Fixture>& fixtures) {
  std::size_t pairs = 0;
  for (const Fixture& fixture : fixtures) pairs += fixture.entrants.size();
  return pairs;
}

Index contacts_of(const Instance& instance) {
  return instance.problem.friction ? instance.problem.friction->contacts() : 0;
}

/// A row about this pair in which nothing has been run yet.
Record blank_record(const RunPlan& plan, const Fixture& fixture, const Entrant& entrant) {
  const Instance& instance = fixture.instance;
  const NamedSolver& solver = *entrant.solver;
  Record record;
  record.instance = instance.name;
  record.place = fixture.place;
  record.start = to_string(entrant.start);
  record.corpus = instance.name.substr(0, instance.name.find('/'));
  record.sha256 = hash_of(instance, entrant.start);
  record.n = instance.problem.size();
  record.contacts = contacts_of(instance);
  record.active_contacts = instance.active_contacts;
  record.solver = solver.spelling;
  record.row = solver.info.name;
  record.version = solver.info.version;
  record.options = nlohmann::json::object();
  for (const Option& option : solver.solver->options()) record.options[option.name] = option.get();
  record.trivial = zero_residual(instance.problem) <= plan.tolerance;
  record.tolerance = plan.tolerance;
  record.jobs = plan.jobs;
  record.environment = plan.environment;
  return record;
}

Verdict verdict_without_answer(Outcome::How how) {
  switch (how) {
    case Outcome::How::timed_out:
      return Verdict::timeout;
    case Outcome::How::overgrown:
      return Verdict::memory;
    default:
      return Verdict::crash;
  }
}

/// One entrant at work on one instance, and the record that comes of it.
class Pair {
 public:
  Pair(const RunPlan& plan, const Fixture& fixture, const Entrant& entrant,
       const std::vector<Island>& islands)
      : plan_(plan),
        instance_(fixture.instance),
        blank_(blank_record(plan, fixture, entrant)),
        record_(blank_),
        worker_(std::make_unique<Worker>(
            [entrant, &islands, &instance = fixture.instance] {
              return solve_islands(*entrant.solver->solver, islands, instance.problem.size(), {},
                                   entrant.start, instance.previous);
            },
            Limits{plan.timeout, plan.memory_bytes, plan.warm_up_below},
            entrant.solver->info.peer() ? std::function<void()>(silence_outside_calls) : [] {})) {}

  bool done() const { return !worker_; }
  const Record& record() const { return record_; }
  Worker& worker() { return *worker_; }

  /// Takes in how a repetition ended. The pair is then either done or to be asked again.
  void take(const Outcome& outcome) {
    if (outcome.how != Outcome::How::answered)
      fail(outcome);
    else if (first_answer_.empty())
      take_first(outcome);
    else
      take_repetition(outcome);
  }

 private:
  void take_first(const Outcome& outcome) {
    first_answer_ = outcome.answer;
    const Judgement judgement = judge(instance_, outcome.result, plan_.tolerance);
    record_.claim = outcome.result.claim;
    record_.message = outcome.result.message;
    record_.verdict = judgement.verdict;
    record_.unclaimed = judgement.unclaimed;
    record_.accuracy = judgement.accuracy;
    record_.work = outcome.result.work;
    if (plan_.keep_answers && judgement.verdict == Verdict::solved) record_.z = outcome.result.z;
    const bool answers =
        outcome.result.claim == Claim::solved && std::isfinite(judgement.accuracy.residual);
    if (!answers || plan_.max_samples == 1 || outcome.time_ns > longest_warm_up_ns) {
      record_.times_ns = {outcome.time_ns};
      finish();
    }
  }

  void take_repetition(const Outcome& outcome) {
    if (outcome.answer != first_answer_) {
      record_.message = fmt::format("repetition {} gave another answer than the first run",
                                    record_.times_ns.size() + 1);
      record_.verdict = Verdict::wrong;
      record_.times_ns = {outcome.time_ns};
      finish();
      return;
    }
    record_.times_ns.push_back(outcome.time_ns);
    if (settled()) finish();
  }

  bool settled() const {
    const std::vector<std::int64_t>& times = record_.times_ns;
    if (times.size() >= static_cast<std::size_t>(plan_.max_samples)) return true;
    if (times.size() < fewest_samples) return false;
    const auto quantile = [&times](double p) {
      return static_cast<double>(*observed_quantile(times, p));
    };
    return quantile(0.75) - quantile(0.25) <= plan_.spread * quantile(0.5);
  }

  void fail(const Outcome& outcome) {
    record_ = blank_;
    record_.verdict = verdict_without_answer(outcome.how);
    record_.message = outcome.message;
    record_.exit_signal = outcome.exit_signal;
    record_.times_ns = {outcome.time_ns};
    finish();
  }

  void finish() {
    record_.stderr_end = worker_->output_end();
    worker_.reset();
  }

  const RunPlan& plan_;
  const Instance& instance_;
  const Record blank_;
  Record record_;
  std::unique_ptr<Worker> worker_;  ///< None once the pair is done.
  std::string first_answer_;
};

/// All entrants on one instance, taking turns: at most one of them is running.
class Match {
 public:
  Match(const RunPlan& plan, const Fixture& fixture)
      : instance_(fixture.instance), islands_(split_islands(instance_.problem)) {
    for (const Entrant& entrant : fixture.entrants)
      pairs_.push_back(std::make_unique<Pair>(plan, fixture, entrant, islands_));
    pairs_[turn_]->worker().ask();
  }

  const Instance& instance() const { return instance_; }
  std::vector<pollfd> watched() const { return pairs_[turn_]->worker().watched(); }
  /// Of the pairs that are done, in the order of the fixture.
  std::vector<Record> records() const {
    std::vector<Record> records;
    for (const auto& pair : pairs_)
      if (pair->done()) records.push_back(pair->record());
    return records;
  }

  bool over() const {
    return std::all_of(pairs_.begin(), pairs_.end(), [](const auto& pair) { return pair->done(); });
  }

  /// Looks after the solve that is running; when it has ended, begins that of the next in
  /// turn. Returns true when this was the last of its pair.
  bool advance() {
    Pair& pair = *pairs_[turn_];
    const std::optional<Outcome> outcome = pair.worker().check();
    if (!outcome) return false;
    pair.take(*outcome);
    const bool pair_done = pair.done();
    if (over()) return pair_done;
    do {
      turn_ = (turn_ + 1) % pairs_.size();
    } while (pairs_[turn_]->done());
    pairs_[turn_]->worker().ask();
    return pair_done;
  }

 private:
  const Instance& instance_;
  const std::vector<Island> islands_;
  std::vector<std::unique_ptr<Pair>> pairs_;
  std::size_t turn_ = 0;
};

using Matches = std::vector<std::unique_ptr<Match>>;

/// Waits until a worker has something to say, a tick at most.
void wait_for_workers(const Matches& matches) {
  std::vector<pollfd> watched;
  for (const auto& match : matches)
    for (const pollfd& file : match->watched()) watched.push_back(file);
  poll(watched.data(), watched.size(), tick_ms);  // An interrupted wait is a short tick.
}

std::vector<Record> not_run_records(const RunPlan& plan, const Fixture& fixture) {
  std::vector<Record> records;
  for (const Entrant& entrant : fixture.entrants) {
    records.push_back(blank_record(plan, fixture, entrant));
    records.back().verdict = Verdict::not_run;
    records.back().message =
        fmt::format("{} contacts, more than {}", contacts_of(fixture.instance), plan.max_contacts);
  }
  return records;
}

}  // namespace

std::vector<PairKey> open_pairs(const RunPlan& plan) {
  std::vector<PairKey> pairs;
  for (const Fixture& fixture : open_fixtures(plan))
    for (const Entrant& entrant : fixture.entrants)
      pairs.push_back(key_of(fixture.instance, entrant));
  return pairs;
}

void run(const RunPlan& plan, const std::function<void(const Record&)>& finished,
         const std::function<void(const Progress&)>& progress,
         const std::atomic<bool>& interrupted) {
  check_plan(plan);
  const std::vector<Fixture> fixtures = open_fixtures(plan);
  Progress state{.done = 0, .total = pairs_of(fixtures), .at = {}};
  const auto report = [&](const Instance& instance, std::size_t pairs) {
    state.done += pairs;
    state.at = instance.name;
    progress(state);
  };
  const auto hand_over = [&](const std::vector<Record>& records) {
    for (const Record& record : records) finished(record);
  };

  Matches matches;
  auto next = fixtures.begin();
  while (!interrupted && (next != fixtures.end() || !matches.empty())) {
    if (next != fixtures.end() && matches.size() < static_cast<std::size_t>(plan.jobs)) {
      const Fixture& fixture = *next++;
      if (contacts_of(fixture.instance) > plan.max_contacts) {
        hand_over(not_run_records(plan, fixture));
        report(fixture.instance, fixture.entrants.size());
      } else {
        matches.push_back(std::make_unique<Match>(plan, fixture));
        report(fixture.instance, 0);
      }
      continue;
    }
    wait_for_workers(matches);
    for (const auto& match : matches)
      if (match->advance()) report(match->instance(), 1);
    for (const auto& match : matches)
      if (match->over()) hand_over(match->records());
    std::erase_if(matches, [](const auto& match) { return match->over(); });
  }
  for (const auto& match : matches) hand_over(match->records());  // those that were interrupted
}

}  // namespace lcp
