#pragma once

#include <map>
#include <string>

#include "solvers/problem.h"

namespace lcp {

/// A problem with its name, where it came from, and the hash of its content.
struct Instance {
  std::string name;  ///< Unique within a corpus: squat-like/0042.
  Problem problem;
  /// Free text by key: source, family, options, seed, scene, time, driver, predecessor, note...
  std::map<std::string, std::string> provenance;
  std::optional<VectorXd> known_solution;  ///< From theory or literature; the judge checks it.
  /// Contacts whose a_i is basic at the solution of the frictionless LCP; empty where unknown.
  std::optional<Index> active_contacts;
  std::string sha256;  ///< Of the problem's content (see content_hash); 64 hexadecimal digits.
};

/// SHA-256 of n, M, q, s_z, s_w, c, pivot limit, whether there are friction blocks (0 or 1), and
/// their fields in the order of FrictionBlocks. Every number is a little-endian IEEE double, -0
/// counting as 0; matrices go column by column behind their rows and columns, lists of row numbers
/// behind their length. Names and provenance do not enter.
std::string content_hash(const Problem& problem);

/// Gives plain scales to a problem that has none, checks it (throws std::invalid_argument naming
/// `name`) and fills the hash.
Instance make_instance(std::string name, Problem problem,
                       std::map<std::string, std::string> provenance);

}  // namespace lcp
