#include "problems/contact/frame_series.h"

#include <fmt/format.h>

#include <algorithm>

namespace lcp {

namespace {

std::string spell_ids(const std::vector<Contact>& contacts) {
  std::string ids;
  for (const Contact& contact : contacts)
    ids += fmt::format("{}{}-{}-{}", ids.empty() ? "" : " ", contact.id.body1, contact.id.body2,
                       contact.id.feature);
  return ids;
}

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
  const Problem frictional = friction_lcp(frame, model_);
  const Problem frictionless = frictionless_lcp(frame);
  const Result with = driver_.solver->solve(frictional);
  const Result without = driver_.solver->solve(frictionless);

  VectorXd forces = VectorXd::Zero(3 * frame.size());
  std::string applied = "none";
  if (with.claim == Claim::solved) {
    forces = contact_forces(*frictional.friction, with.z);
    applied = "frictional";
  } else {
    ++fallbacks_;
    if (without.claim == Claim::solved) {
      forces = contact_forces(*frictionless.friction, without.z);
      applied = "frictionless";
    }
  }

  const std::string predecessor = instances_.empty() ? "none" : instances_.back().name;
  Instance instance =
      make_instance(fmt::format("{}/{:04}", scene_, instances_.size()), frictional,
                    {{"scene", scene_},
                     {"time", fmt::format("{}", time)},
                     {"driver", driver_.spelling},
                     {"predecessor", predecessor},
                     {"start", start.empty() ? fmt::format("forces of {}", predecessor) : start},
                     {"applied", applied},
                     {"fallbacks", std::to_string(fallbacks_)},
                     {"contact_ids", spell_ids(frame.contacts)}});
  instance.active_contacts = active_contacts(without, frame.size());
  instances_.push_back(std::move(instance));
  return forces;
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
