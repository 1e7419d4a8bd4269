#include "problems/contact/contact_problem.h"

#include <fmt/format.h>

#include <cmath>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// Sine of the angle below which a direction does not tell a tangent from the normal.
constexpr double kParallelSine = 1e-6;

template <class... Arguments>
[[noreturn]] void refuse(const std::string& where, fmt::format_string<Arguments...> text,
                         Arguments&&... arguments) {
  throw InvalidArgument(where + ": " + fmt::format(text, std::forward<Arguments>(arguments)...));
}

void require_velocity(const VectorXd& velocity, Index contacts, const std::string& where,
                      const char* field) {
  if (velocity.size() != 3 * contacts)
    refuse(where, "{} has {} entries, expected {}", field, velocity.size(), 3 * contacts);
  for (Index i = 0; i < velocity.size(); ++i)
    if (!std::isfinite(velocity(i)))
      refuse(where, "{}({}) is {}, expected a finite number", field, i, velocity(i));
}

}  // namespace

Contact make_contact(const Eigen::Vector3d& normal, const Eigen::Vector3d& along, double mu,
                     ContactId id) {
  const double length = normal.norm();
  if (!(length > 0)) refuse("contact frame", "the normal is zero, expected a direction");
  const Eigen::Vector3d n = normal / length;
  const Eigen::Vector3d tangent = along - along.dot(n) * n;
  if (!(tangent.norm() > kParallelSine * along.norm()))
    refuse("contact frame",
           "({}, {}, {}) is parallel to the normal, expected a direction across it", along.x(),
           along.y(), along.z());
  const Eigen::Vector3d t1 = tangent.normalized();
  return {n, t1, n.cross(t1), mu, id};
}

std::string spell_ids(const std::vector<Contact>& contacts) {
  std::string ids;
  for (const Contact& contact : contacts)
    ids += fmt::format("{}{}-{}-{}", ids.empty() ? "" : " ", contact.id.body1, contact.id.body2,
                       contact.id.feature);
  return ids;
}

MatrixXd contact_axes(const std::vector<Contact>& contacts) {
  MatrixXd axes(3 * contacts.size(), 3);
  Index row = 0;
  for (const Contact& contact : contacts)
    for (const Eigen::Vector3d* axis : {&contact.n, &contact.t1, &contact.t2})
      axes.row(row++) = axis->transpose();
  return axes;
}

MatrixXd delassus_matrix(const MatrixXd& A, double dt) {
  MatrixXd W = MatrixXd::Zero(A.cols(), A.cols());
  if (A.size() == 0) return W;  // rankUpdate reads the first entry
  W.selfadjointView<Eigen::Lower>().rankUpdate(A.transpose(), dt);
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
  return W;
}

void check(const ContactProblem& problem, const std::string& where) {
  const Index contacts = problem.size();
  if (problem.W.rows() != 3 * contacts || problem.W.cols() != 3 * contacts)
    refuse(where, "W is {} x {}, expected {} x {}", problem.W.rows(), problem.W.cols(),
           3 * contacts, 3 * contacts);
  const double largest = contacts > 0 ? problem.W.cwiseAbs().maxCoeff() : 0;
  for (Index j = 0; j < 3 * contacts; ++j) {
    for (Index i = 0; i < 3 * contacts; ++i) {
      if (!std::isfinite(problem.W(i, j)))
        refuse(where, "W({}, {}) is {}, expected a finite number", i, j, problem.W(i, j));
      if (std::abs(problem.W(i, j) - problem.W(j, i)) > problem.asymmetry_allowed * largest)
        refuse(where, "W({}, {}) is {} but W({}, {}) is {}, expected a symmetric W", i, j,
               problem.W(i, j), j, i, problem.W(j, i));
    }
  }
  require_velocity(problem.vbar, contacts, where, "vbar");
  if (problem.v_before.size() > 0) require_velocity(problem.v_before, contacts, where, "v_before");
  for (Index i = 0; i < contacts; ++i)
    if (!(problem.contacts[i].mu >= 0) || !std::isfinite(problem.contacts[i].mu))
      refuse(where, "mu of contact {} is {}, expected 0 or more", i, problem.contacts[i].mu);
  if (!(problem.dt > 0)) refuse(where, "dt is {}, expected a positive time", problem.dt);
}

}  // namespace lcp
