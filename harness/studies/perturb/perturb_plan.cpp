#include "harness/studies/perturb/perturb_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace lcp {

namespace {

struct NamedUnits {
  const char* name;
  Units units;
};
constexpr NamedUnits unit_systems[] = {
    {"mm", {.length = 1e3}}, {"kn", {.force = 1e-3}}, {"mm-kn", {.length = 1e3, .force = 1e-3}}};

constexpr int largest_exponent = 6;

/// A generator for one draw, the same on every machine: FNV-1a of what it belongs to.
Random random_for(const Instance& instance, DisturbanceKind kind, Index number,
                  std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : fmt::format("{} {} {} {}", seed, to_string(kind), number, instance.name))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return Random(hash);
}

/// The exponents of scale-q in the order in which an instance meets them.
std::vector<int> exponents(const Instance& instance, std::uint64_t seed) {
  std::vector<int> drawn;
  Random random = random_for(instance, DisturbanceKind::scale_q, 0, seed);
  for (const Index place : random.permutation(2 * largest_exponent)) {
    const int exponent = static_cast<int>(place) - largest_exponent;
    drawn.push_back(exponent < 0 ? exponent : exponent + 1);  // 0 changes nothing
  }
  return drawn;
}

Disturbed rotated(const Instance& instance, Random random, const std::optional<double>& angle,
                  const std::string& label) {
  const FrictionBlocks& blocks = *instance.problem.friction;
  if (angle) {
    const double largest = *angle * std::numbers::pi / 180;
    VectorXd angles(blocks.contacts());
    for (double& each : angles) each = random.between(-largest, largest);
    return turned_by_angles(instance, angles, label);
  }
  std::vector<Index> steps;
  for (Index i = 0; i < blocks.contacts(); ++i)
    steps.push_back(random.integer(1, blocks.directions_per_contact - 1));
  return turned_by_steps(instance, steps, label);
}

template <class T>
void get(const nlohmann::json& json, const char* field, T& value) {
  try {
    json.at(field).get_to(value);
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(fmt::format("field '{}': {}", field, error.what()));
  }
}

}  // namespace

void to_json(nlohmann::json& json, const PerturbOptions& options) {
  std::vector<std::string> kinds;
  for (const DisturbanceKind kind : options.kinds) kinds.push_back(to_string(kind));
  json = {{"kinds", kinds},
          {"trials", options.trials},
          {"seed", options.seed},
          {"last_bits", options.last_bits},
          {"angle", options.angle ? nlohmann::json(*options.angle) : nlohmann::json()}};
}

void from_json(const nlohmann::json& json, PerturbOptions& options) {
  options = {};
  std::vector<std::string> kinds;
  get(json, "kinds", kinds);
  options.kinds.clear();
  for (const std::string& kind : kinds) options.kinds.push_back(from_string<DisturbanceKind>(kind));
  get(json, "trials", options.trials);
  get(json, "seed", options.seed);
  get(json, "last_bits", options.last_bits);
  if (json.contains("angle") && !json.at("angle").is_null()) {
    options.angle.emplace();
    get(json, "angle", *options.angle);
  }
}

std::string reason_against(DisturbanceKind kind, const Problem& problem) {
  if (kind == DisturbanceKind::permutation) return {};
  return kind == DisturbanceKind::rotation ? reason_against_turning(problem)
                                           : reason_against_reassembly(problem);
}

std::vector<Disturbance> disturbances_of(const Instance& instance, const PerturbOptions& options) {
  std::vector<Disturbance> trials;
  for (const DisturbanceKind kind : options.kinds) {
    if (!reason_against(kind, instance.problem).empty()) continue;
    std::vector<std::string> variants;
    if (kind == DisturbanceKind::units) {
      for (const NamedUnits& each : unit_systems) variants.emplace_back(each.name);
    } else if (kind == DisturbanceKind::scale_q) {
      for (const int exponent : exponents(instance, options.seed))
        variants.push_back(fmt::format("1e{}", exponent));
    } else {
      for (Index k = 1; k <= options.trials; ++k) variants.push_back(fmt::format("{}", k));
    }
    for (Index k = 0; k < std::min<Index>(options.trials, std::ssize(variants)); ++k)
      trials.push_back({kind, k, fmt::format("{}-{}", to_string(kind), variants[k])});
  }
  return trials;
}

Disturbed disturb(const Instance& instance, const Disturbance& trial,
                  const PerturbOptions& options) {
  Random random = random_for(instance, trial.kind, trial.number, options.seed);
  switch (trial.kind) {
    case DisturbanceKind::noise:
      return with_noise(instance, options.last_bits, random, trial.label);
    case DisturbanceKind::permutation:
      return permuted(instance, random_order(instance.problem, random), trial.label);
    case DisturbanceKind::units:
      return in_units(instance, unit_systems[trial.number].units, trial.label);
    case DisturbanceKind::rotation:
      return rotated(instance, std::move(random), options.angle, trial.label);
    case DisturbanceKind::scale_q:
      return with_scaled_q(instance, exponents(instance, options.seed).at(trial.number),
                           trial.label);
  }
  throw std::invalid_argument("unknown kind of disturbance");
}

Expansion expansion(const PerturbOptions& options) {
  return {[options](const Instance& instance) {
            return 1 + static_cast<Index>(disturbances_of(instance, options).size());
          },
          [options](const Instance& instance) {
            std::vector<Instance> all = {instance};
            for (const Disturbance& trial : disturbances_of(instance, options))
              all.push_back(disturb(instance, trial, options).instance);
            return all;
          }};
}

}  // namespace lcp
