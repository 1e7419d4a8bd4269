#include "problems/contact/friction_directions.h"

#include <cmath>
#include <numbers>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// cos(2 pi k / turn), `turn` a multiple of 4. Folded into the first eighth of a turn, so that
/// symmetric angles give the same bits and quarter turns are exact.
double cosine(Index k, Index turn) {
  k = ((k % turn) + turn) % turn;
  if (2 * k > turn) k = turn - k;
  if (4 * k > turn) return -cosine(turn / 2 - k, turn);
  if (4 * k == turn) return 0;
  const double step = 2 * std::numbers::pi / static_cast<double>(turn);
  return 8 * k <= turn ? std::cos(step * static_cast<double>(k))
                       : std::sin(step * static_cast<double>(turn / 4 - k));
}

}  // namespace

MatrixXd regular_directions(Index m) {
  MatrixXd directions(2, m);
  // In units of 1 / (4 m) of a turn a sine is the cosine m units earlier.
  for (Index k = 0; k < m; ++k) directions.col(k) << cosine(4 * k, 4 * m), cosine(4 * k - m, 4 * m);
  return directions;
}

MatrixXd friction_directions(const ContactProblem& problem, const FrictionModel& model) {
  const Index m = model.directions;
  if (m < 2 || m % 2 != 0)
    throw InvalidArgument("friction directions: {} per contact, expected an even number from 2", m);
  const bool follow_slip = model.axes == FrictionModel::Axes::slip;
  if (follow_slip && problem.v_before.size() != 3 * problem.size())
    throw InvalidArgument(
        "friction directions: axes along the slip velocity need v_before with {} entries, it has "
        "{}",
        3 * problem.size(), problem.v_before.size());

  const MatrixXd regular = regular_directions(m);
  MatrixXd directions = regular.replicate(1, problem.size());
  if (!follow_slip) return directions;
  for (Index i = 0; i < problem.size(); ++i) {
    const Eigen::Vector2d slip = problem.v_before.segment<2>(3 * i + 1);
    if (!(slip.norm() > model.slip_threshold)) continue;
    const Eigen::Vector2d first = slip.normalized();
    Eigen::Matrix2d turn;
    turn << first.x(), -first.y(), first.y(), first.x();
    for (Index k = 0; k < m / 2; ++k) {
      directions.col(i * m + k) = turn * regular.col(k);
      directions.col(i * m + k + m / 2) = -directions.col(i * m + k);
    }
  }
  return directions;
}

}  // namespace lcp
