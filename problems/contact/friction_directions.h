#pragma once

#include "problems/contact/contact_problem.h"

namespace lcp {

/// How the friction cone is made polyhedral.
struct FrictionModel {
  enum class Axes {
    fixed,  ///< The first direction is t1.
    slip,   ///< The first direction is the slip velocity where a contact slides, else t1.
  };

  Index directions = 8;  ///< m per contact: even, >= 2. In the plane m = 2: +t1 and -t1.
  Axes axes = Axes::fixed;
  double slip_threshold = 1e-3;  ///< m/s: a contact whose |v-_t| exceeds this slides.
};

/// The first m of the directions below, 2 x m: those of a contact whose first one is t1. m even, >= 2.
MatrixXd regular_directions(Index m);

/// Unit directions c_im in the contacts' tangent planes, 2 x Nc m, columns i m ... i m + m - 1 for
/// contact i, coordinates along (t1, t2): direction k stands at angle 2 pi k / m from the first
/// one. c_i,k+m/2 = -c_ik holds bit for bit; multiples of a quarter turn are exact.
///
/// Throws std::invalid_argument if m is odd or below 2, or if axes follow the slip velocity and the
/// problem does not know v-. Source: Yamane and Nakamura 2008, IV-B, before (17).
MatrixXd friction_directions(const ContactProblem& problem, const FrictionModel& model);

}  // namespace lcp
