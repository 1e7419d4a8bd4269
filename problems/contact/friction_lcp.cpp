#include "problems/contact/friction_lcp.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// A column of N or C (20): the direction in which an unknown of kind a or b pushes its contact.
struct Push {
  Index row;  ///< Of the unknown.
  Index contact;
  Eigen::Vector3d axis;  ///< (1, 0, 0) for a, (0, c_im) for b.
};

/// Blocks with directions and the row layout [a | b | lambda].
FrictionBlocks lay_out(const ContactProblem& problem, const FrictionModel& model) {
  const Index contacts = problem.size(), m = model.directions;
  FrictionBlocks blocks;
  blocks.W = problem.W;
  blocks.vbar = problem.vbar;
  blocks.mu.resize(contacts);
  blocks.directions = friction_directions(problem, model);
  blocks.directions_per_contact = m;
  Index rubbing = 0;
  for (Index i = 0; i < contacts; ++i) {
    blocks.mu(i) = problem.contacts[i].mu;
    blocks.normal_row.push_back(i);
    blocks.friction_row.push_back(blocks.mu(i) > 0 ? contacts + m * rubbing++ : -1);
  }
  Index cone_row = contacts + m * rubbing;
  for (Index i = 0; i < contacts; ++i)
    blocks.cone_row.push_back(blocks.mu(i) > 0 ? cone_row++ : -1);
  return blocks;
}

/// The columns of [N | C] in the order of a and b.
std::vector<Push> pushes(const FrictionBlocks& blocks) {
  const Index m = blocks.directions_per_contact;
  std::vector<Push> columns;
  for (Index i = 0; i < blocks.contacts(); ++i)
    columns.push_back({blocks.normal_row[i], i, Eigen::Vector3d::UnitX()});
  for (Index i = 0; i < blocks.contacts(); ++i) {
    if (blocks.friction_row[i] < 0) continue;
    for (Index k = 0; k < m; ++k) {
      const auto c = blocks.directions.col(i * m + k);
      columns.push_back({blocks.friction_row[i] + k, i, {0, c.x(), c.y()}});
    }
  }
  return columns;
}

}  // namespace

Problem assemble_friction_lcp(FrictionBlocks blocks) {
  const Index m = blocks.directions_per_contact;
  const std::vector<Push> columns = pushes(blocks);
  Index n = static_cast<Index>(columns.size());
  for (const Index row : blocks.cone_row) n += row >= 0;

  Problem problem;
  problem.M = MatrixXd::Zero(n, n);
  problem.q = VectorXd::Zero(n);
  // [N | C]' W [N | C], where opposite directions give opposite numbers to the last bit.
  std::vector<Eigen::Vector3d> velocities(blocks.contacts());  // of all contacts, by one unit push
  for (const Push& column : columns) {
    const auto block = blocks.W.middleCols<3>(3 * column.contact);
    for (Index k = 0; k < blocks.contacts(); ++k)
      velocities[k] = block.middleRows<3>(3 * k) * column.axis;
    for (const Push& row : columns)
      problem.M(row.row, column.row) = row.axis.dot(velocities[row.contact]);
    problem.q(column.row) = column.axis.dot(blocks.vbar.segment<3>(3 * column.contact));
  }
  for (Index i = 0; i < blocks.contacts(); ++i) {
    const Index cone = blocks.cone_row[i];
    if (cone < 0) continue;
    problem.M(cone, blocks.normal_row[i]) = blocks.mu(i);
    problem.M.row(cone).segment(blocks.friction_row[i], m).setConstant(-1);
    problem.M.col(cone).segment(blocks.friction_row[i], m).setConstant(1);
  }
  problem.friction = std::move(blocks);
  set_contact_scales(problem);
  return problem;
}

void set_contact_scales(Problem& problem) {
  const FrictionBlocks& blocks = *problem.friction;
  double largest = 0, diagonal = 0;
  for (Index i = 0; i < blocks.vbar.size(); ++i)
    largest = std::max(largest, std::abs(blocks.vbar(i)));
  for (Index i = 0; i < blocks.contacts(); ++i) diagonal += blocks.W(3 * i, 3 * i);
  const double v_scale = largest > 0 ? largest : 1;
  const double f_scale =
      diagonal > 0 ? v_scale * static_cast<double>(blocks.contacts()) / diagonal : v_scale;
  problem.s_z = VectorXd::Constant(problem.size(), f_scale);
  problem.s_w = VectorXd::Constant(problem.size(), v_scale);
  for (const Index row : blocks.cone_row)
    if (row >= 0) std::swap(problem.s_z(row), problem.s_w(row));
}

Problem friction_lcp(const ContactProblem& problem, const FrictionModel& model) {
  check(problem, "contact problem");
  return assemble_friction_lcp(lay_out(problem, model));
}

Problem frictionless_lcp(const ContactProblem& problem) {
  ContactProblem smooth = problem;
  for (Contact& contact : smooth.contacts) contact.mu = 0;
  return friction_lcp(smooth);
}

bool has_friction(const Problem& problem) {
  return problem.friction && (problem.friction->mu.array() > 0).any();
}

Problem frictionless_part(const Problem& problem) {
  if (!problem.friction)
    throw std::invalid_argument("frictionless part: the problem has no friction blocks");
  Problem part = restricted(problem, problem.friction->normal_row);
  FrictionBlocks& blocks = part.friction.emplace(*problem.friction);
  blocks.mu.setZero();
  std::iota(blocks.normal_row.begin(), blocks.normal_row.end(), Index{0});
  std::fill(blocks.friction_row.begin(), blocks.friction_row.end(), Index{-1});
  blocks.cone_row = blocks.friction_row;
  return part;
}

VectorXd contact_forces(const FrictionBlocks& blocks, const VectorXd& z) {
  const Index m = blocks.directions_per_contact;
  const auto require_row = [&](Index row) {
    if (row >= z.size())
      throw InvalidArgument("contact forces: z has {} entries, expected more than {}", z.size(),
                            row);
  };
  VectorXd forces = VectorXd::Zero(3 * blocks.contacts());
  for (Index i = 0; i < blocks.contacts(); ++i) {
    require_row(blocks.normal_row[i]);
    forces(3 * i) = z(blocks.normal_row[i]);
    if (blocks.friction_row[i] < 0) continue;
    require_row(blocks.friction_row[i] + m - 1);
    forces.segment<2>(3 * i + 1) =
        blocks.directions.middleCols(i * m, m) * z.segment(blocks.friction_row[i], m);
  }
  return forces;
}

VectorXd post_velocities(const FrictionBlocks& blocks, const VectorXd& forces) {
  if (forces.size() != blocks.vbar.size())
    throw InvalidArgument("post velocities: f has {} entries, expected {}", forces.size(),
                          blocks.vbar.size());
  return blocks.W * forces + blocks.vbar;
}

}  // namespace lcp
