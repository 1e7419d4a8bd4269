#include "harness/studies/shrink/shrink.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>
#include <stdexcept>

#include "harness/studies/shrink/ddmin.h"
#include "harness/studies/shrink/parts.h"

namespace lcp {

namespace {

Index contacts_of(const Problem& problem) {
  return problem.friction ? problem.friction->contacts() : 0;
}

Index directions_of(const Problem& problem) {
  return problem.friction ? problem.friction->directions_per_contact : 0;
}

/// Leaves of `count` parts of a problem as few as `keep` can make do with.
void take_parts(Problem& problem, Trials& trials, Index count,
                Problem (*keep)(const Problem&, const std::vector<Index>&)) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<Index> left =
      ddmin(all, [&](const std::vector<Index>& kept) { return trials.keeps(keep(problem, kept)); });
  if (left.size() < all.size()) problem = keep(problem, left);
}

void take_contacts(Problem& problem, Trials& trials) {
  take_parts(problem, trials, contacts_of(problem), keep_contacts);
}

void take_rows(Problem& problem, Trials& trials) {
  take_parts(problem, trials, problem.size(), restricted);
}

void take_directions(Problem& problem, Trials& trials) {
  while (can_halve_directions(problem)) {
    Problem half = halve_directions(problem);
    if (!trials.keeps(half)) return;
    problem = std::move(half);
  }
}

/// The fewest digits, tried from 1 up: fewer may do where more do not.
void take_digits(Problem& problem, Trials& trials) {
  const int now = digits_of(problem);
  for (int digits = 1; digits < now; ++digits) {
    Problem round = round_numbers(problem, digits);
    if (!trials.keeps(round)) continue;
    problem = std::move(round);
    return;
  }
}

/// Takes what `steps` take, until they find nothing more.
void repeat(Problem& problem, Trials& trials,
            const std::vector<void (*)(Problem&, Trials&)>& steps) {
  std::string before;
  do {
    before = content_hash(problem);
    for (const auto& step : steps) step(problem, trials);
  } while (content_hash(problem) != before);
}

std::vector<Reduction> reductions(const Problem& parent, const Problem& last,
                                  const Problem& with_contacts) {
  std::vector<Reduction> all = {{"rows", parent.size(), last.size()}};
  if (parent.friction) {
    all.push_back({"contacts", contacts_of(parent), contacts_of(with_contacts)});
    all.push_back({"directions", directions_of(parent), directions_of(with_contacts)});
  }
  all.push_back({"digits", digits_of(parent), digits_of(last)});
  return all;
}

std::string spelled(const std::vector<Reduction>& reductions) {
  std::vector<std::string> words;
  for (const Reduction& each : reductions)
    words.push_back(fmt::format("{} {} -> {}", each.what, each.from, each.to));
  return fmt::format("{}", fmt::join(words, ", "));
}

void require_failure(const Instance& parent, const Invariant& invariant, const Trial& before) {
  const std::string who = fmt::format("{}: {}", parent.name, invariant.solver.spelling);
  if (before.verdict == Verdict::unsupported)
    throw std::invalid_argument(who + " does not apply (unsupported), expected one that fails");
  if (before.solved())
    throw std::invalid_argument(who + " solves it: nothing fails that could be shrunk");
  if (invariant.keep == Invariant::Keep::failure && !is_failure(before))
    throw std::invalid_argument(who +
                                " finds a solution although it claims a failure; "
                                "expected one that fails, or --keep verdict");
  if (invariant.solvable && before.trivial)
    throw std::invalid_argument(
        parent.name + ": z = 0 solves it, expected a problem that is not trivial (--no-solvable)");
}

/// How the instance given fares; what is asked of smaller ones must hold for it.
Fared begin(const Instance& parent, const Invariant& invariant, Trials& trials) {
  Fared fared;
  fared.keeps = true;
  fared.solver = trials.run(invariant.solver, parent.problem);
  if (fared.solver.verdict == Verdict::not_run) return fared;  // interrupted
  require_failure(parent, invariant, fared.solver);
  if (!trials.rule_solves(parent.problem) && !trials.interrupted())
    throw std::invalid_argument(
        fmt::format("{}: the rule of {} does not solve it in 113 bits either, so that rounding is "
                    "not what fails (see lcpbench replay): expected --by-rounding no more",
                    parent.name, invariant.solver.spelling));
  if (!invariant.solvable) return fared;
  fared.reference = trials.run(invariant.reference, parent.problem);
  if (!fared.reference.solved() && fared.reference.verdict != Verdict::not_run)
    throw std::invalid_argument(fmt::format(
        "{}: the reference {} does not solve it ({}), so that the failure may be the problem's: "
        "give another --reference, or --no-solvable",
        parent.name, invariant.reference.spelling, to_string(fared.reference.verdict)));
  return fared;
}

Instance named(const Instance& parent, const Invariant& invariant, const Trial& after,
               const std::vector<Reduction>& reductions, Problem problem) {
  const bool any = invariant.keep == Invariant::Keep::failure;
  Instance instance = make_instance(
      "shrunk", std::move(problem),
      {{"parent", parent.name},
       {"parent_sha256", parent.sha256},
       {"solver", invariant.solver.spelling},
       {"verdict", to_string(after.verdict)},
       {"keep", any ? "failure" : "verdict"},
       {"reference", invariant.solvable ? invariant.reference.spelling : "none asked for"},
       {"by_rounding", invariant.by_rounding ? "asked for" : "not asked for"},
       {"tolerance", shortest(invariant.tolerance)},
       {"taken_away", spelled(reductions)}});
  instance.name = fmt::format("shrunk/{}-{}-{}", invariant.solver.info.name,
                              to_string(after.verdict), instance.sha256.substr(0, 8));
  return instance;
}

}  // namespace

Shrunk shrink(const Instance& parent, const Invariant& invariant, const ShrinkOptions& options,
              const std::atomic<bool>& interrupted) {
  Trials trials(invariant, options.limits, options.max_solves, interrupted, options.progress);
  Shrunk shrunk;
  const Fared first = begin(parent, invariant, trials);
  trials.begin_with(parent.problem, first);

  Problem with_contacts = parent.problem;
  if (with_contacts.friction) repeat(with_contacts, trials, {take_contacts, take_directions});
  Problem problem = with_contacts;
  repeat(problem, trials, {take_rows, take_digits});

  const Fared& last = trials.fared(problem);
  shrunk.before = first.solver;
  shrunk.after = last.solver;
  shrunk.reference = last.reference;
  shrunk.reductions = reductions(parent.problem, problem, with_contacts);
  shrunk.solves = trials.solves();
  shrunk.minimal = !trials.stopped();
  shrunk.instance = named(parent, invariant, last.solver, shrunk.reductions, std::move(problem));
  return shrunk;
}

}  // namespace lcp
