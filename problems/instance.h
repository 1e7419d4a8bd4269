#pragma once

#include <map>
#include <string>

#include "solvers/problem.h"
#include "solvers/result.h"

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
  /// Solution of the frame before this one, carried over to its rows (carried_over in
  /// problems/contact/carried_over.h); empty where there was none, or where it was not solved.
  std::optional<Start> previous;
  std::string sha256;  ///< Of the problem's content (see content_hash); 64 hexadecimal digits.
};

/// SHA-256 of n, M, q, s_z, s_w, c, pivot limit, whether there are friction blocks (0 or 1), and
/// their fields in the order of FrictionBlocks. Every number is a little-endian IEEE double, -0
/// counting as 0; matrices go column by column behind their rows and columns, lists of row numbers
/// behind their length. Names and provenance do not enter.
std::string content_hash(const Problem& problem);

/// SHA-256 of an instance together with its previous solution: of the digits of sha256, alpha and z,
/// numbers as above. Equal to sha256 where there is no previous solution. What a solver does from
/// `previous` depends on both, what it does otherwise on the content alone.
std::string hash_with_previous(const Instance& instance);

/// Throws std::invalid_argument, beginning with `where`, unless alpha ascends within 0 ... n - 1 and z
/// is empty or n finite numbers.
void check(const Start& start, Index n, const std::string& where);

/// Gives plain scales to a problem without scales, checks it (throws std::invalid_argument naming
/// `name`) and fills the hash.
Instance make_instance(std::string name, Problem problem,
                       std::map<std::string, std::string> provenance);

}  // namespace lcp
