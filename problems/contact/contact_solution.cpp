#include "problems/contact/contact_solution.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "problems/contact/two_step.h"

namespace lcp {

namespace {

/// Contacts whose a_i is basic; nothing where the method keeps no basis.
std::optional<std::vector<Index>> active_contacts(const Result& without,
                                                  const FrictionBlocks& rows) {
  if (!without.basis) return std::nullopt;
  std::vector<Index> active;
  for (Index i = 0; i < rows.contacts(); ++i)
    if (std::binary_search(without.basis->begin(), without.basis->end(), rows.normal_row[i]))
      active.push_back(i);
  return active;
}

ContactProblem subset(const ContactProblem& problem, const std::vector<Index>& contacts) {
  std::vector<Index> axes;
  ContactProblem part;
  part.dt = problem.dt;
  part.asymmetry_allowed = std::numeric_limits<double>::infinity();  // checked with the whole
  for (const Index i : contacts) {
    part.contacts.push_back(problem.contacts[i]);
    for (Index k = 0; k < 3; ++k) axes.push_back(3 * i + k);
  }
  part.W = problem.W(axes, axes);
  part.vbar = problem.vbar(axes);
  if (problem.v_before.size() > 0) part.v_before = problem.v_before(axes);
  return part;
}

/// Puts the answer for the contacts `kept` into the rows of the full LCP. The others carry no force;
/// their lambda is the slip speed they get, their w what M z + q gives where that is not negative,
/// so that the error of w is the speed at which they sink.
Result expanded(const Result& part, const FrictionBlocks& part_rows, const Problem& full,
                const std::vector<Index>& kept) {
  const FrictionBlocks& rows = *full.friction;
  const Index m = rows.directions_per_contact;
  Result whole = part;
  whole.z = VectorXd::Zero(full.size());
  VectorXd own_w = VectorXd::Constant(full.size(), -1);
  std::vector<Index> basis;
  const bool has_w = part.w.size() == part.z.size();
  const auto take = [&](Index from, Index to) {
    whole.z(to) = part.z(from);
    if (has_w) own_w(to) = part.w(from);
    if (part.basis && std::binary_search(part.basis->begin(), part.basis->end(), from))
      basis.push_back(to);
  };
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::vector<Index> from = part_rows.rows_of(k), to = rows.rows_of(kept[k]);
    for (std::size_t r = 0; r < to.size(); ++r) take(from[r], to[r]);
  }
  const VectorXd velocity = post_velocities(rows, contact_forces(rows, whole.z));
  for (Index i = 0; i < rows.contacts(); ++i) {
    if (rows.cone_row[i] < 0 || std::binary_search(kept.begin(), kept.end(), i)) continue;
    const VectorXd along =
        rows.directions.middleCols(i * m, m).transpose() * velocity.segment<2>(3 * i + 1);
    Index most = 0;  // against the slip
    whole.z(rows.cone_row[i]) = std::max(0.0, -along.minCoeff(&most));
    if (whole.z(rows.cone_row[i]) > 0) {
      // lambda alone would be a zero column of the basis: b along `most` is basic with it, at 0.
      basis.push_back(rows.friction_row[i] + most);
      basis.push_back(rows.cone_row[i]);
    }
  }
  if (has_w) {
    const VectorXd w = full.M * whole.z + full.q;
    whole.w = (own_w.array() < 0).select(w.cwiseMax(0), own_w);
  }
  if (part.basis) {
    std::sort(basis.begin(), basis.end());
    whole.basis = std::move(basis);
  }
  whole.covering.resize(0);
  return whole;
}

/// What the frictional LCP of some contacts, with these rows, starts from: nothing where the model starts
/// cold or what it wants is not known. `active` are contacts of the whole, contact k of the LCP is
/// contact `of_whole[k]` there.
Call started(const ContactModel& model, const std::vector<Contact>& contacts,
             const Problem& problem, const std::optional<SolutionByContact>& previous,
             const std::optional<std::vector<Index>>& active, const std::vector<Index>& of_whole,
             const MatrixXd& W_nn) {
  using From = ContactModel::Start;
  const FrictionBlocks& rows = *problem.friction;
  Call call;
  if (model.start == From::previous && previous)
    call.start = carried_over(*previous, rows, contacts, problem.size());
  if (model.start == From::cold || model.start == From::previous || !active) return call;
  const std::vector<Index> normals =
      model.start == From::all_active ? *active
                                      : independent_contacts(*active, W_nn, kIndependentContacts);
  call.start.emplace();
  for (std::size_t k = 0; k < of_whole.size(); ++k)
    if (std::binary_search(normals.begin(), normals.end(), of_whole[k]))
      call.start->alpha.push_back(rows.normal_row[k]);
  return call;
}

/// The rule of V-A.
void apply(const ContactProblem& problem, ContactSolution& solution) {
  solution.forces = VectorXd::Zero(3 * problem.size());
  if (solution.solved_with) {
    solution.applied = Applied::frictional;
    solution.forces = contact_forces(*solution.frictional.friction, solution.with_friction.z);
  } else if (solution.solved_without) {
    solution.applied = Applied::frictionless;
    solution.forces = contact_forces(*solution.frictionless.friction, solution.without_friction.z);
  }
}

}  // namespace

ContactSolution solve_contacts(const ContactProblem& problem, const ContactModel& model,
                               const ContactSolver& solver,
                               const std::optional<SolutionByContact>& previous) {
  ContactSolution solution;
  solution.frictional = friction_lcp(problem, model.friction);
  solution.frictionless = frictionless_lcp(problem);
  solution.without_friction = solver.solve(solution.frictionless, {});
  solution.solved_without = solver.accept(solution.frictionless, solution.without_friction);
  std::optional<std::vector<Index>> active;
  if (solution.solved_without)
    active = active_contacts(solution.without_friction, *solution.frictionless.friction);
  if (active) solution.active = static_cast<Index>(active->size());
  if (!has_friction(solution.frictional)) {
    solution.with_friction = solution.without_friction;
    solution.solved_with = solution.solved_without;
    apply(problem, solution);
    return solution;
  }

  const bool has_start =
      model.start == ContactModel::Start::previous ? previous.has_value() : active.has_value();
  const MatrixXd& W_nn = solution.frictionless.M;
  if (active && model.active_only) {
    const ContactProblem kept = subset(problem, *active);
    const Problem part = friction_lcp(kept, model.friction);
    const Call call = started(model, kept.contacts, part, previous, active, *active, W_nn);
    solution.with_friction =
        expanded(solver.solve(part, call), *part.friction, solution.frictional, *active);
  } else {
    std::vector<Index> all(problem.contacts.size());
    std::iota(all.begin(), all.end(), Index{0});
    solution.with_friction = solver.solve(
        solution.frictional,
        started(model, problem.contacts, solution.frictional, previous, active, all, W_nn));
  }
  if (model.start != ContactModel::Start::cold && !has_start)
    ++solution.with_friction.work.restarts;
  solution.solved_with = solver.accept(solution.frictional, solution.with_friction);

  apply(problem, solution);
  return solution;
}

FrameSolutions accepted_solutions(const ContactSolution& solution,
                                  const std::vector<Contact>& contacts) {
  FrameSolutions accepted;
  if (solution.solved_with)
    accepted.frictional =
        by_contact(solution.with_friction, *solution.frictional.friction, contacts);
  if (solution.solved_without)
    accepted.frictionless =
        by_contact(solution.without_friction, *solution.frictionless.friction, contacts);
  return accepted;
}

}  // namespace lcp
