#include "harness/studies/perturb/perturb_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "harness/studies/shrink/parts.h"
#include "problems/contact/friction_lcp.h"

namespace lcp {

namespace {

/// z_rows[j] = factors[j] z'_j, of a disturbed z' and the original z.
struct RowMap {
  std::vector<Index> rows;
  VectorXd factors;

  /// Every row in its place.
  explicit RowMap(VectorXd by) : rows(by.size()), factors(std::move(by)) {
    std::iota(rows.begin(), rows.end(), Index{0});
  }
  explicit RowMap(std::vector<Index> order)
      : rows(std::move(order)), factors(VectorXd::Ones(static_cast<Index>(rows.size()))) {}

  VectorXd back(const VectorXd& disturbed) const {
    VectorXd z(disturbed.size());
    z(rows) = factors.cwiseProduct(disturbed);
    return z;
  }
  VectorXd forth(const VectorXd& original) const { return original(rows).cwiseQuotient(factors); }
};

/// What the instance is called and where it comes from. Contact ids are not kept: they tell the order
/// of contacts.
Instance renamed(const Instance& instance, Problem problem, const std::string& label) {
  std::map<std::string, std::string> provenance = instance.provenance;
  provenance.erase("contact_ids");
  provenance["disturbance"] = label;
  provenance["undisturbed"] = instance.name;
  Instance result = make_instance(instance.name + "~" + label, std::move(problem), provenance);
  result.active_contacts = instance.active_contacts;
  return result;
}

Disturbed mapped(const Instance& instance, Problem problem, RowMap map, const std::string& label) {
  Disturbed result{renamed(instance, std::move(problem), label), {}};
  if (instance.known_solution) result.instance.known_solution = map.forth(*instance.known_solution);
  if (instance.previous) {
    Start& start = result.instance.previous.emplace();
    const std::vector<Index>& alpha = instance.previous->alpha;
    for (Index j = 0; j < static_cast<Index>(map.rows.size()); ++j)
      if (std::binary_search(alpha.begin(), alpha.end(), map.rows[j])) start.alpha.push_back(j);
    if (instance.previous->z.size() > 0) start.z = map.forth(instance.previous->z);
  }
  result.back = [map = std::move(map)](const VectorXd& z) { return map.back(z); };
  return result;
}

/// A problem as its kind is made: by assembly, or with plain scales.
Problem made(Problem problem) {
  if (problem.friction) return assemble_friction_lcp(std::move(*problem.friction));
  set_plain_scales(problem);
  return problem;
}

/// Makes a changed problem, whose z is the original's times z_factors and whose w is it times
/// w_factors.
Problem remade(const Problem& original, Problem changed, const VectorXd& z_factors,
               const VectorXd& w_factors) {
  Problem problem = made(std::move(changed)), plain = made(original);
  if (plain.s_z != original.s_z || plain.s_w != original.s_w) {  // scales of its own
    problem.s_z = original.s_z.cwiseProduct(z_factors);
    problem.s_w = original.s_w.cwiseProduct(w_factors);
  }
  if (original.c.size() > 0) problem.c = original.c.cwiseProduct(w_factors);
  problem.pivot_limit = original.pivot_limit;
  return problem;
}

void require_none(const std::string& reason, const Instance& instance) {
  if (!reason.empty()) throw std::invalid_argument(instance.name + ": " + reason);
}

/// A problem to be changed, with the numbers that make it: W and vbar, without blocks M and q.
struct Numbers {
  Problem problem;

  explicit Numbers(const Instance& instance) : problem(instance.problem) {
    require_none(reason_against_reassembly(problem), instance);
  }
  MatrixXd& matrix() { return problem.friction ? problem.friction->W : problem.M; }
  VectorXd& vector() { return problem.friction ? problem.friction->vbar : problem.q; }
};

/// T of a contact's axes turned about the normal by an angle: new coordinates are T times the old.
Eigen::Matrix2d turn(double cosine, double sine) {
  Eigen::Matrix2d T;
  T << cosine, sine, -sine, cosine;
  return T;
}

/// The problem with contact i's tangent axes turned by turns[i].
Problem turned(const Problem& original, const std::vector<Eigen::Matrix2d>& turns) {
  Problem changed = original;
  FrictionBlocks& blocks = *changed.friction;
  const bool symmetric = blocks.W == blocks.W.transpose();
  for (Index i = 0; i < blocks.contacts(); ++i) {
    const Eigen::Matrix2d& T = turns[i];
    const Index first = 3 * i + 1;
    blocks.vbar.segment<2>(first) = (T * blocks.vbar.segment<2>(first)).eval();
    blocks.W.middleRows<2>(first) = (T * blocks.W.middleRows<2>(first)).eval();
    blocks.W.middleCols<2>(first) = (blocks.W.middleCols<2>(first) * T.transpose()).eval();
  }
  if (symmetric) blocks.W.triangularView<Eigen::StrictlyUpper>() = MatrixXd(blocks.W.transpose());
  const VectorXd ones = VectorXd::Ones(original.size());
  return remade(original, std::move(changed), ones, ones);
}

/// b >= 0 on the two directions (columns, ascending angle) next to a tangential force, which they sum
/// up to.
VectorXd on_nearest_directions(const MatrixXd& directions, const Eigen::Vector2d& force) {
  const Index m = directions.cols();
  VectorXd b = VectorXd::Zero(m);
  if (m == 2) {
    const double along = directions.col(0).dot(force);
    b(along > 0 ? 0 : 1) = std::abs(along);
    return b;
  }
  Index nearest = 0;
  (directions.transpose() * force).maxCoeff(&nearest);
  const auto side = [&](Index other) {
    Eigen::Matrix2d pair;
    pair << directions.col(nearest), directions.col(other);
    return Eigen::Vector2d(pair.inverse() * force);
  };
  Index other = (nearest + 1) % m;
  if (side(other)(1) < 0) other = (nearest + m - 1) % m;
  const Eigen::Vector2d shares = side(other);
  b(nearest) = shares(0);
  b(other) = std::max(0.0, shares(1));
  return b;
}

}  // namespace

std::string reason_against_reassembly(const Problem& problem) {
  if (!problem.friction || problem.size() == 0) return {};
  const Problem whole = assemble_friction_lcp(*problem.friction);
  const auto near = [](const MatrixXd& one, const MatrixXd& two) {
    return (one - two).cwiseAbs().maxCoeff() <=
           reassembly_tolerance * std::max(one.cwiseAbs().maxCoeff(), two.cwiseAbs().maxCoeff());
  };
  if (whole.size() != problem.size() || !near(whole.M, problem.M) || !near(whole.q, problem.q))
    return "M and q are not those of its friction blocks";
  return {};
}

Disturbed with_noise(const Instance& instance, Index last_bits, Random& random,
                     const std::string& label) {
  Numbers changed(instance);
  const auto disturb_number = [&](double& number) {
    const auto k = static_cast<double>(random.integer(-last_bits, last_bits));
    number *= 1 + std::ldexp(k, -52);
  };
  MatrixXd& M = changed.matrix();
  const bool symmetric = M == M.transpose();
  for (Index j = 0; j < M.cols(); ++j)
    for (Index i = symmetric ? j : 0; i < M.rows(); ++i) disturb_number(M(i, j));
  if (symmetric) M.triangularView<Eigen::StrictlyUpper>() = MatrixXd(M.transpose());
  for (double& number : changed.vector()) disturb_number(number);
  const VectorXd ones = VectorXd::Ones(instance.problem.size());
  return mapped(instance, remade(instance.problem, std::move(changed.problem), ones, ones),
                RowMap(ones), label);
}

Order random_order(const Problem& problem, Random& random) {
  std::vector<std::vector<Index>> groups;  // of rows that stay together
  Order order;
  if (problem.friction) {
    const FrictionBlocks& blocks = *problem.friction;
    for (Index i = 0; i < blocks.contacts(); ++i) {
      groups.push_back({blocks.normal_row[i]});
      if (blocks.friction_row[i] < 0) continue;
      groups.push_back({blocks.cone_row[i]});
      std::vector<Index>& along = groups.emplace_back(blocks.directions_per_contact);
      std::iota(along.begin(), along.end(), blocks.friction_row[i]);
    }
    order.contacts = random.permutation(blocks.contacts());
  } else {
    for (Index i = 0; i < problem.size(); ++i) groups.push_back({i});
  }
  for (const Index group : random.permutation(static_cast<Index>(groups.size())))
    order.rows.insert(order.rows.end(), groups[group].begin(), groups[group].end());
  return order;
}

namespace {

std::vector<Index> inverse_of(const std::vector<Index>& order) {
  std::vector<Index> places(order.size());
  for (std::size_t j = 0; j < order.size(); ++j) places[order[j]] = static_cast<Index>(j);
  return places;
}

FrictionBlocks permuted_blocks(const FrictionBlocks& blocks, const Order& order) {
  const Index m = blocks.directions_per_contact;
  const std::vector<Index> place_of = inverse_of(order.rows);
  std::vector<Index> axes, directions;
  FrictionBlocks result;
  for (const Index i : order.contacts) {
    for (Index k = 0; k < 3; ++k) axes.push_back(3 * i + k);
    for (Index k = 0; k < m; ++k) directions.push_back(m * i + k);
    const auto place = [&](Index row) { return row < 0 ? row : place_of[row]; };
    result.normal_row.push_back(place(blocks.normal_row[i]));
    result.friction_row.push_back(place(blocks.friction_row[i]));
    result.cone_row.push_back(place(blocks.cone_row[i]));
  }
  result.W = blocks.W(axes, axes);
  result.vbar = blocks.vbar(axes);
  result.mu = blocks.mu(order.contacts);
  result.directions = blocks.directions(Eigen::all, directions);
  result.directions_per_contact = m;
  return result;
}

}  // namespace

Order inverse(const Order& order) { return {inverse_of(order.rows), inverse_of(order.contacts)}; }

Disturbed permuted(const Instance& instance, const Order& order, const std::string& label) {
  Problem problem = restricted(instance.problem, order.rows);
  if (instance.problem.friction)
    problem.friction = permuted_blocks(*instance.problem.friction, order);
  return mapped(instance, std::move(problem), RowMap(order.rows), label);
}

Disturbed in_units(const Instance& instance, const Units& units, const std::string& label) {
  Numbers changed(instance);
  const Problem& original = instance.problem;
  VectorXd z_factors = VectorXd::Constant(original.size(), units.force);
  VectorXd w_factors = VectorXd::Constant(original.size(), units.length);
  changed.matrix() *= units.length / units.force;
  changed.vector() *= units.length;
  if (original.friction)
    for (const Index row : original.friction->cone_row)
      if (row >= 0) std::swap(z_factors(row), w_factors(row));
  return mapped(instance, remade(original, std::move(changed.problem), z_factors, w_factors),
                RowMap(z_factors.cwiseInverse()), label);
}

std::string reason_against_turning(const Problem& problem) {
  if (!has_friction(problem)) return "no contact has friction";
  const FrictionBlocks& blocks = *problem.friction;
  const Index m = blocks.directions_per_contact;
  const Eigen::Vector2d step = regular_directions(m).col(1);
  const Eigen::Matrix2d to_next = turn(step.x(), step.y()).transpose();
  for (Index i = 0; i < blocks.contacts(); ++i) {
    if (blocks.friction_row[i] < 0) continue;
    for (Index k = 0; k < m; ++k) {
      const Eigen::Vector2d next = blocks.directions.col(i * m + (k + 1) % m);
      if (!((to_next * blocks.directions.col(i * m + k) - next).norm() <= polygon_tolerance))
        return "the friction directions are no regular polygon";
    }
  }
  return reason_against_reassembly(problem);
}

Disturbed turned_by_steps(const Instance& instance, const std::vector<Index>& steps,
                          const std::string& label) {
  require_none(reason_against_turning(instance.problem), instance);
  const FrictionBlocks& blocks = *instance.problem.friction;
  const Index m = blocks.directions_per_contact;
  const MatrixXd regular = regular_directions(m);
  std::vector<Eigen::Matrix2d> turns;
  RowMap map(VectorXd::Ones(instance.problem.size()));
  for (Index i = 0; i < blocks.contacts(); ++i) {
    const Index step = ((steps.at(i) % m) + m) % m;
    turns.push_back(turn(regular(0, step), regular(1, step)));
    if (blocks.friction_row[i] < 0) continue;
    for (Index k = 0; k < m; ++k)
      map.rows[blocks.friction_row[i] + k] = blocks.friction_row[i] + (k + step) % m;
  }
  return mapped(instance, turned(instance.problem, turns), std::move(map), label);
}

Disturbed turned_by_angles(const Instance& instance, const VectorXd& angles,
                           const std::string& label) {
  require_none(reason_against_turning(instance.problem), instance);
  std::vector<Eigen::Matrix2d> turns;
  for (const double angle : angles) turns.push_back(turn(std::cos(angle), std::sin(angle)));
  Disturbed result{renamed(instance, turned(instance.problem, turns), label), {}};
  result.back = [blocks = *instance.problem.friction, turns](const VectorXd& z) {
    const Index m = blocks.directions_per_contact;
    const VectorXd forces = contact_forces(blocks, z);
    VectorXd original = z;
    for (Index i = 0; i < blocks.contacts(); ++i) {
      if (blocks.friction_row[i] < 0) continue;
      original.segment(blocks.friction_row[i], m) =
          on_nearest_directions(blocks.directions.middleCols(i * m, m),
                                turns[i].transpose() * forces.segment<2>(3 * i + 1));
    }
    return original;
  };
  return result;
}

Disturbed with_scaled_q(const Instance& instance, int exponent, const std::string& label) {
  Numbers changed(instance);
  const double factor = std::pow(10, exponent);
  changed.vector() *= factor;
  const VectorXd factors = VectorXd::Constant(instance.problem.size(), factor);
  Problem problem = remade(instance.problem, std::move(changed.problem), factors, factors);
  problem.c = instance.problem.c;  // z0 grows with q
  return mapped(instance, std::move(problem), RowMap(factors.cwiseInverse()), label);
}

}  // namespace lcp
