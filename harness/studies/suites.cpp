#include "harness/studies/suites.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

/// The own rows, and every peer that is built in.
std::vector<std::string> own_solvers_and_peers() {
  std::vector<std::string> all = rows_in_suites();
  for (const Row& row : registry())
    if (row.info.peer()) all.push_back(row.info.name);
  return all;
}

/// {tableau, factorised} x {no search, search} x {lowest row, lexicographic order} x {pivot tolerance
/// off, on}, everything else equal: the same scale, epsilon, e_max and delta, one attempt of the
/// search, nothing polished, each basis of the factorised rows factorised afresh.
std::vector<std::string> sixteen_cells() {
  const std::string search =
      "epsilon=1e-9,e_max=1e-6,scale=on,polish=off,patience=0,max_nodes=3000";
  std::vector<std::string> all;
  for (const std::string& rule :
       {std::string("lemke:scale=on"), std::string("lexicographic:delta=1e-9,scale=on"),
        "best-first-tableau:order=row," + search,
        "best-first-tableau:order=lexicographic," + search,
        std::string("lemke-revised:refactor_every=1"),
        std::string("lexicographic-revised:delta=1e-9,refactor_every=1"),
        "best-first:order=row,refactor_every=1," + search,
        "best-first-lexicographic:refactor_every=1," + search})
    for (const char* pivot : {"0", "1e-12"}) all.push_back(rule + ",pivot=" + pivot);
  return all;
}

/// Table I, with the paper's constants in its units, and the best-first search as it describes it.
const std::vector<std::string>& paper_columns() {
  static const std::vector<std::string> all = {
      "lemke",
      "lexicographic:delta=0",
      "lexicographic:delta=1e-8",
      "lexicographic:delta=1e-6",
      "lexicographic:delta=1e-4",
      "best-first-tableau:max_nodes=300",
      "best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off",
  };
  return all;
}

using Parts = std::vector<SuitePart>;

Parts small_parts() {
  return {{.family = "published"},
          {.family = "ben-gharbia-gilbert"},
          {.family = "bimatrix"},
          {.family = "csizmadia"},
          {.family = "fathi"},
          {.family = "fathi:variant=2"},
          {.family = "fathi:variant=3"},
          {.family = "murty"},
          {.family = "random-p"},
          {.family = "random-p:kind=dominant"},
          {.family = "random-p:kind=triangular"},
          {.family = "semidefinite"},
          {.family = "semidefinite:integer=on"}};
}

Parts contact_parts() {
  return {{.family = "squat-like"},
          {.family = "draped-chain"},
          {.family = "body-on-plane"},
          {.family = "body-on-plane:layout=collinear"},
          {.family = "body-on-plane:layout=duplicated"},
          {.family = "body-on-plane:layout=noisy"},
          {.family = "body-on-plane:motion=sliding"},
          {.family = "peg-in-hole"},
          {.family = "stack"},
          {.family = "stack:mass_ratio=1"}};
}

constexpr Index largest_scaled = 200;  // Contacts.

Parts scaling_parts() {
  Parts parts;
  for (const char* family :
       {"body-on-plane:contacts=8", "body-on-plane:contacts=32", "body-on-plane:contacts=64",
        "body-on-plane:contacts=128", "draped-chain:links=13,wrapped=6",
        "draped-chain:links=52,wrapped=26", "draped-chain:links=100,wrapped=50",
        "stack:bodies=2,mass_ratio=1", "stack:bodies=8,mass_ratio=1",
        "stack:bodies=16,mass_ratio=1", "stack:bodies=32,mass_ratio=1"})
    parts.push_back({.family = family, .count = 5});
  // On the rod 20 ms after the start, from a drop that is over by then.
  for (const int links : {25, 50, 100, 200})
    parts.push_back(
        {.count = 40,
         .every = 8,
         .scene = fmt::format("hoist:links={},plates=1,lift=0,toss=0,clearance=0", links)});
  return parts;
}

Parts joined(const std::vector<Parts>& all) {
  Parts together;
  for (const Parts& parts : all) together.insert(together.end(), parts.begin(), parts.end());
  return together;
}

Parts thinned_to(Index every, Parts parts) {
  for (SuitePart& part : parts) part.every = every;
  return parts;
}

constexpr std::uint64_t suite_seed = 1;

/// The first `count` frames of a scene that have contacts, driven by best-first.
std::vector<Instance> frames_of(const std::string& text, Index count) {
  const NamedScene scene = make_scene(text);
  const NamedSolver solver = make_solver("best-first");
  const ContactSolver driver = {
      .solve = [&](const Problem& problem,
                   const Call& call) { return solver.solver->solve(problem, call); },
      .accept = [](const Problem&, const Result& result) { return result.claim == Claim::solved; }};
  Simulation simulation(scene.setup.system, scene.setup.stepping);
  std::vector<Instance> frames;
  while (static_cast<Index>(frames.size()) < count) {
    simulation.step(driver, [&](const Frame& frame) {
      if (frame.points.empty()) return;
      frames.push_back(make_instance(fmt::format("{}/{:05}", scene.spelling, frame.number),
                                     frame.solution.frictional,
                                     {{"scene", scene.spelling},
                                      {"time", fmt::format("{}", frame.state.time)},
                                      {"driver", solver.spelling},
                                      {"contact_ids", spell_ids(frame.contacts.contacts)}}));
      frames.back().active_contacts = frame.solution.active;
      const Problem& problem = frame.solution.frictional;
      if (frame.before.frictional)
        frames.back().previous = carried_over(*frame.before.frictional, *problem.friction,
                                              frame.contacts.contacts, problem.size());
    });
  }
  return frames;
}

Index drawn(const SuitePart& part) {
  if (part.count > 0) return part.count;
  const std::string name = parse_spelling(part.family).name;
  for (const FamilyRow& row : families())
    if (row.info.name == name) return row.info.default_count;
  throw std::invalid_argument(fmt::format("no family '{}', which a suite needs", name));
}

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"contact", "every contact family in full", contact_parts(), rows_in_suites()},
      {"default",
       "published instances and the contact families, thinned; under two minutes on two cores",
       {{.family = "published"},
        {.family = "squat-like", .every = 4},
        {.family = "draped-chain", .every = 2},
        {.family = "body-on-plane", .every = 5},
        {.family = "peg-in-hole", .every = 5},
        {.family = "stack", .every = 5}},
       rows_in_suites()},
      {"full", "all of small, contact and scaling",
       joined({small_parts(), contact_parts(), scaling_parts()}), rows_in_suites(), largest_scaled},
      {"paper",
       "the columns of the paper's tables, with its constants, on the families nearest to its "
       "scenes",
       {{.family = "squat-like"}, {.family = "draped-chain"}},
       paper_columns()},
      {"peers", "the own solvers and every peer that is built in, on all kinds of problem, thinned",
       thinned_to(5, joined({small_parts(), contact_parts()})), own_solvers_and_peers()},
      {"scaling", "contact families and chains of 25 to 200 links, from few contacts to many",
       scaling_parts(), rows_in_suites(), largest_scaled},
      {"sixteen-cells",
       "pivot tolerance, arithmetic, tie order and search, each on and off",
       {{.family = "draped-chain"},
        {.family = "squat-like"},
        {.family = "squat-like:contacts=64", .count = 60}},
       sixteen_cells(),
       64},
      {"small", "published instances and every generated family without contacts", small_parts(),
       rows_in_suites()},
  };
  return all;
}

const Suite& find_suite(const std::string& name) {
  std::vector<std::string> names;
  for (const Suite& suite : suites()) {
    names.push_back(suite.name);
    if (suite.name == name) return suite;
  }
  throw std::invalid_argument(
      fmt::format("unknown suite '{}', known are: {}", name, fmt::join(names, ", ")));
}

Index size(const Suite& suite) {
  Index total = 0;
  for (const SuitePart& part : suite.parts) total += (drawn(part) + part.every - 1) / part.every;
  return total;
}

std::vector<Instance> generate(const Suite& suite) {
  std::vector<Instance> all;
  for (const SuitePart& part : suite.parts) {
    std::vector<Instance> kept = thinned(
        part.scene.empty() ? generate(part.family, {.count = drawn(part), .seed = suite_seed})
                           : frames_of(part.scene, part.count),
        part.every, 0);
    std::move(kept.begin(), kept.end(), std::back_inserter(all));
  }
  return all;
}

std::optional<FamilyDraw> family_draw(const std::string& suite, const std::string& family) {
  for (const Suite& each : suites()) {
    if (each.name != suite) continue;
    for (const SuitePart& part : each.parts)
      if (part.scene.empty() && full_family_spelling(part.family) == family)
        return FamilyDraw{family, drawn(part), suite_seed};
  }
  return std::nullopt;
}

std::string corpus_of(const std::string& instance) {
  return instance.substr(0, instance.find('/'));
}

std::vector<Instance> thinned(std::vector<Instance> instances, Index every, Index limit) {
  std::map<std::string, Index> seen;
  std::vector<Instance> kept;
  for (Instance& instance : instances) {
    const Index place = seen[corpus_of(instance.name)]++;
    if (place % every == 0 && (limit == 0 || place / every < limit))
      kept.push_back(std::move(instance));
  }
  return kept;
}

}  // namespace lcp
