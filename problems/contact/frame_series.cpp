#include "problems/contact/frame_series.h"

#include <fmt/format.h>

#include <algorithm>

#include "problems/contact/contact_solution.h"

namespace lcp {

namespace {

/// Contacts whose a_i is basic; nothing where the driver failed or works without a basis.
std::optional<Index> active_contacts(const Result& frictionless, Index contacts) {
  if (frictionless.claim != Claim::solved || !frictionless.basis) return std::nullopt;
  return std::count_if(frictionless.basis->begin(), frictionless.basis->end(),
                       [contacts](Index row) { return row < contacts; });
}

}  // namespace

FrameSeries::FrameSeries(std::string scene, const std::string& driver, FrictionModel model)
    : scene_(std::move(scene)), driver_(make_solver(driver)), model_(model) {}

VectorXd FrameSeries::add(const ContactProblem& frame, double time, const std::string& start) {
  const ContactSolver driver = {
      [this](const Problem& problem, const Call& call) {
        return driver_.solver->solve(problem, call);
      },
      [](const Problem&, const Result& result) { return result.claim == Claim::solved; }};
  ContactSolution solution =
      solve_contacts(frame, {.friction = model_, .start = ContactModel::Start::cold}, driver);
  fallbacks_ += solution.applied != Applied::frictional;

  const std::string predecessor = instances_.empty() ? "none" : instances_.back().name;
  Instance instance =
      make_instance(fmt::format("{}/{:04}", scene_, instances_.size()), solution.frictional,
                    {{"scene", scene_},
                     {"time", fmt::format("{}", time)},
                     {"driver", driver_.spelling},
                     {"predecessor", predecessor},
                     {"start", start.empty() ? fmt::format("forces of {}", predecessor) : start},
                     {"applied", to_string(solution.applied)},
                     {"fallbacks", std::to_string(fallbacks_)},
                     {"contact_ids", spell_ids(frame.contacts)}});
  instance.active_contacts = solution.active;
  if (last_.frictional)
    instance.previous = carried_over(*last_.frictional, *solution.frictional.friction,
                                     frame.contacts, solution.frictional.size());
  instances_.push_back(std::move(instance));
  last_ = accepted_solutions(solution, frame.contacts);
  return solution.forces;
}

Instance lone_frame(const std::string& scene, Index number, const ContactProblem& frame,
                    const FrictionModel& model, const NamedSolver& driver,
                    std::map<std::string, std::string> provenance) {
  provenance["scene"] = scene;
  provenance["driver"] = driver.spelling;
  provenance["contact_ids"] = spell_ids(frame.contacts);
  Instance instance = make_instance(fmt::format("{}/{:04}", scene, number),
                                    friction_lcp(frame, model), std::move(provenance));
  instance.active_contacts =
      active_contacts(driver.solver->solve(frictionless_lcp(frame)), frame.size());
  return instance;
}

}  // namespace lcp
