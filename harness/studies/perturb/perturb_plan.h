#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/runs/run_directory.h"
#include "harness/studies/perturb/perturb_kinds.h"
#include "solvers/names.h"

namespace lcp {

/// Kinds of disturbance; what each does is told in perturb_kinds.h.
enum class DisturbanceKind {
  noise,        ///< Last bits of M and q (W and vbar).
  permutation,  ///< Rows and contacts in another order.
  units,        ///< mm, kN, and both.
  rotation,     ///< Tangent axes of each contact turned.
  scale_q,      ///< q times a power of ten, 1e-6 ... 1e6.
};

/// Which disturbances an instance meets.
struct PerturbOptions {
  std::vector<DisturbanceKind> kinds = all_values<DisturbanceKind>();
  /// Disturbed versions per instance and kind; at most 3 of `units` and 12 of `scale-q`, of which
  /// there are no more.
  Index trials = 5;
  std::uint64_t seed = 1;  ///< Of every draw, with the instance's name, the kind and the trial.
  Index last_bits = 1;     ///< noise: largest |k| of 1 + k 2^-52.
  /// rotation: largest angle (degrees) of any that are drawn; empty for multiples of the spacing of the
  /// friction directions, which leave the problem what it is.
  std::optional<double> angle;

  bool operator==(const PerturbOptions&) const = default;
};

void to_json(nlohmann::json& json, const PerturbOptions& options);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, PerturbOptions& options);

/// One disturbed version of an instance, by name.
struct Disturbance {
  DisturbanceKind kind;
  Index number = 0;   ///< From 0, within its kind.
  std::string label;  ///< `noise-3`, `units-mm`, `scale-q-1e-3`: behind `~` in the instance's name.
};

/// The trials an instance meets, by kind in the order of the options; none of a kind for which
/// reason_against names a reason. Without cost, but for the reasons' O(n^2).
std::vector<Disturbance> disturbances_of(const Instance& instance, const PerturbOptions& options);

/// Why an instance meets no trial of this kind; empty where it does.
std::string reason_against(DisturbanceKind kind, const Problem& problem);

/// Makes one of disturbances_of. The draw depends on seed, kind, number and the instance's name alone.
Disturbed disturb(const Instance& instance, const Disturbance& trial,
                  const PerturbOptions& options);

/// For run_into: each instance as it is, and then in all its trials.
Expansion expansion(const PerturbOptions& options);

}  // namespace lcp
