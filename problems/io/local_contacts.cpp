#include "problems/io/local_contacts.h"

#include <fmt/format.h>

#include <stdexcept>

#include "problems/contact/friction_lcp.h"
#include "problems/features.h"
#include "problems/io/errors.h"
#include "problems/io/limits.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

/// In the plane there are two directions, there and back.
Index directions_in(Index dimension, const ReadOptions& options) {
  return dimension == 2 ? 2 : options.directions;
}

/// The same contacts with a second tangent that nothing moves along.
LocalContacts in_space(const LocalContacts& plane) {
  const Index contacts = plane.mu.size();
  LocalContacts space;
  space.mu = plane.mu;
  space.q = VectorXd::Zero(3 * contacts);
  space.W = MatrixXd::Zero(3 * contacts, 3 * contacts);
  for (Index j = 0; j < contacts; ++j) {
    space.q.segment<2>(3 * j) = plane.q.segment<2>(2 * j);
    for (Index i = 0; i < contacts; ++i)
      space.W.block<2, 2>(3 * i, 3 * j) = plane.W.block<2, 2>(2 * i, 2 * j);
  }
  return space;
}

ContactProblem to_contact_problem(LocalContacts local) {
  ContactProblem problem;
  problem.asymmetry_allowed = foreign_asymmetry;
  // The file knows its contacts' own axes only; those of the world serve for all.
  for (Index i = 0; i < local.mu.size(); ++i)
    problem.contacts.push_back(
        make_contact(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), local.mu(i), {i, -1, 0}));
  problem.W = std::move(local.W);
  problem.vbar = std::move(local.q);
  return problem;
}

}  // namespace

void check(const ReadOptions& options) {
  if (options.directions < 2 || options.directions % 2 != 0 || options.directions > largest_rows)
    throw InvalidArgument("--directions is {}, expected an even number in 2 ... {}",
                          options.directions, largest_rows);
}

void require_readable_size(Index contacts, Index dimension, const ReadOptions& options,
                           const std::string& where) {
  const Index rows_each = directions_in(dimension, options) + 2;
  if (contacts > largest_rows / rows_each)
    throw UnreadableInput(
        "{}: {} contacts with {} directions make an LCP of {} rows, expected at most {}", where,
        contacts, rows_each - 2, contacts * rows_each, largest_rows);
}

Instance contact_instance(const std::string& name, LocalContacts local, const ReadOptions& options,
                          std::map<std::string, std::string> provenance, const std::string& where) {
  require_readable_size(local.mu.size(), local.dimension, options, where);
  FrictionModel model;
  model.directions = directions_in(local.dimension, options);
  provenance["dimension"] = fmt::format("{}", local.dimension);
  provenance["directions"] = fmt::format("{}", model.directions);
  provenance["asymmetry of W"] = fmt::format("{:.3g}", asymmetry_of(local.W));
  if (local.dimension == 2) local = in_space(local);
  try {
    Problem problem = friction_lcp(to_contact_problem(std::move(local)), model);
    return make_instance(name, std::move(problem), std::move(provenance));
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput("{}: {}", where, error.what());
  }
}

}  // namespace lcp
