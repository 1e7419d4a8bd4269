#include "problems/rigid/cubic_spline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp {

CubicSpline::CubicSpline(MatrixXd values, double spacing)
    : values_(std::move(values)), spacing_(spacing) {
  const Index last = values_.cols() - 1;
  if (last < 1 || !(spacing > 0))
    throw std::invalid_argument("spline: expected 2 knots or more, a positive time apart");
  if (!values_.allFinite()) throw std::invalid_argument("spline: a value is not finite");
  // m_{k-1} + 4 m_k + m_{k+1} = 6 (y_{k+1} - 2 y_k + y_{k-1}) / h^2, and 2 m_0 + m_1 = 6 (y_1 - y_0)
  // / h^2 at a clamped end; by elimination (Thomas), stable because the diagonal dominates.
  const double scale = 6 / (spacing * spacing);
  VectorXd upper(last + 1);
  second_.resize(values_.rows(), last + 1);
  for (Index k = 0; k <= last; ++k) {
    VectorXd right = VectorXd::Zero(values_.rows());
    if (k < last) right += scale * (values_.col(k + 1) - values_.col(k));
    if (k > 0) right -= scale * (values_.col(k) - values_.col(k - 1));
    double diagonal = k == 0 || k == last ? 2 : 4;
    if (k > 0) {
      diagonal -= upper(k - 1);
      right -= second_.col(k - 1);
    }
    upper(k) = 1 / diagonal;
    second_.col(k) = right / diagonal;
  }
  for (Index k = last - 1; k >= 0; --k) second_.col(k) -= upper(k) * second_.col(k + 1);
}

CubicSpline::Point CubicSpline::at(double time) const {
  const Index last = values_.cols() - 1;
  const double end = spacing_ * static_cast<double>(last);
  if (std::isnan(time)) throw std::invalid_argument("spline: the time is not a number");
  if (time <= 0 || time >= end) {
    const VectorXd zero = VectorXd::Zero(values_.rows());
    return {values_.col(time <= 0 ? 0 : last), zero, zero};
  }
  const Index k = std::min(last - 1, static_cast<Index>(std::floor(time / spacing_)));
  const double h = spacing_, b = time / h - static_cast<double>(k), a = 1 - b;
  const auto y0 = values_.col(k), y1 = values_.col(k + 1);
  const auto m0 = second_.col(k), m1 = second_.col(k + 1);
  return {a * y0 + b * y1 + h * h / 6 * ((a * a * a - a) * m0 + (b * b * b - b) * m1),
          (y1 - y0) / h + h / 6 * ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1), a * m0 + b * m1};
}

}  // namespace lcp
