#include "problems/families/contact/bead_chain.h"

#include <cmath>

#include "problems/decompositions.h"
#include "problems/rigid/spatial.h"

namespace lcp {

namespace {

constexpr double kGravity = 9.81;  // m/s^2

/// Rotational inertia of link i about its centre, to a power: 1, 1/2, -1/2.
Matrix3d inertia_power(const BeadChain& chain, Index i, double power) {
  const double across = chain.masses(i) * chain.link_length * chain.link_length / 12;
  const Matrix3d along = chain.axes.col(i) * chain.axes.col(i).transpose();
  return std::pow(across, power) * (Matrix3d::Identity() - along) +
         std::pow(chain.axial_share * across, power) * along;
}

/// Applies M^power to the rows of `rows_by_link` (6 L x k).
MatrixXd times_inertia(const BeadChain& chain, double power, const MatrixXd& rows_by_link) {
  MatrixXd product(rows_by_link.rows(), rows_by_link.cols());
  for (Index i = 0; i < chain.links(); ++i) {
    product.middleRows<3>(6 * i) =
        std::pow(chain.masses(i), power) * rows_by_link.middleRows<3>(6 * i);
    product.middleRows<3>(6 * i + 3) =
        inertia_power(chain, i, power) * rows_by_link.middleRows<3>(6 * i + 3);
  }
  return product;
}

/// Row block that maps a link's twist to the velocity of its point at `arm` from its centre.
Eigen::Matrix<double, 3, 6> point_velocity(const Vector3d& arm) {
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << Matrix3d::Identity(), -skew(arm);
  return jacobian;
}

/// P, by an orthonormal basis of what the joints forbid: the range of M^-1/2 G'.
class JointProjection {
 public:
  explicit JointProjection(const BeadChain& chain) {
    const Index joints = chain.links() - 1;
    MatrixXd G = MatrixXd::Zero(3 * joints, 6 * chain.links());
    for (Index k = 0; k < joints; ++k) {
      const double half = chain.link_length / 2;
      G.block<3, 6>(3 * k, 6 * k) = point_velocity(half * chain.axes.col(k));
      G.block<3, 6>(3 * k, 6 * k + 6) = -point_velocity(-half * chain.axes.col(k + 1));
    }
    forbidden_ = orthonormal_basis(times_inertia(chain, -0.5, G.transpose()));
  }

  MatrixXd operator()(const MatrixXd& vectors) const {
    return vectors - forbidden_ * (forbidden_.transpose() * vectors);
  }

 private:
  MatrixXd forbidden_;
};

struct BeadContact {
  Contact contact;
  Index link;
  Vector3d arm;  ///< From the link's centre to the contact point.
  double gap;    ///< Negative when the bead is inside the rod.
};

std::vector<BeadContact> collide(const BeadChain& chain, const FixedRod& rod) {
  const MatrixXd centres = chain.centres();
  std::vector<BeadContact> found;
  for (Index i = 0; i < chain.links(); ++i) {
    for (const Index bead : {0, 1}) {
      const Vector3d offset = (bead == 0 ? -1 : 1) * chain.bead_offset * chain.axes.col(i);
      const Vector3d centre = centres.col(i) + offset;
      const Vector3d radial(centre.x(), 0, centre.z());
      const double gap = radial.norm() - rod.radius - chain.bead_radius;
      if (gap > rod.margin) continue;
      const Vector3d around = Vector3d::UnitY().cross(radial);
      const Contact contact = make_contact(radial, around, rod.mu, {i + 1, 0, bead});
      found.push_back({contact, i, offset - chain.bead_radius * contact.n, gap});
    }
  }
  return found;
}

/// nu + dt M^-1 h: every link falls and turns for itself.
VectorXd fall(const BeadChain& chain, double dt) {
  VectorXd nu = chain.nu;
  for (Index i = 0; i < chain.links(); ++i) {
    nu(6 * i + 2) -= dt * kGravity;
    const Vector3d omega = chain.nu.segment<3>(6 * i + 3);
    const Vector3d spin = inertia_power(chain, i, 1) * omega;
    nu.segment<3>(6 * i + 3) -= dt * inertia_power(chain, i, -1) * omega.cross(spin);
  }
  return nu;
}

}  // namespace

MatrixXd BeadChain::centres() const {
  MatrixXd centres(3, links());
  Vector3d joint = head;
  for (Index i = 0; i < links(); ++i) {
    centres.col(i) = joint + link_length / 2 * axes.col(i);
    joint += link_length * axes.col(i);
  }
  return centres;
}

void BeadChain::advance(double dt) {
  const Vector3d arm = -link_length / 2 * axes.col(0);
  head += dt * (nu.segment<3>(0) + Vector3d(nu.segment<3>(3)).cross(arm));
  for (Index i = 0; i < links(); ++i) {
    const Vector3d omega = nu.segment<3>(6 * i + 3), axis = axes.col(i);
    axes.col(i) = (axis + dt * omega.cross(axis)).normalized();
  }
}

ChainStep::ChainStep(const BeadChain& chain, const FixedRod& rod, double dt) {
  const std::vector<BeadContact> beads = collide(chain, rod);
  problem_.dt = dt;
  for (const BeadContact& bead : beads) problem_.contacts.push_back(bead.contact);
  const MatrixXd axes = contact_axes(problem_.contacts);
  J_ = MatrixXd::Zero(axes.rows(), 6 * chain.links());
  for (Index i = 0; i < problem_.size(); ++i)
    J_.block<3, 6>(3 * i, 6 * beads[i].link) =
        axes.middleRows<3>(3 * i) * point_velocity(beads[i].arm);

  const JointProjection project(chain);
  const MatrixXd A = project(times_inertia(chain, -0.5, J_.transpose()));
  problem_.W = delassus_matrix(A, dt);
  response_ = dt * times_inertia(chain, -0.5, A);
  nu_free_ = times_inertia(chain, -0.5, project(times_inertia(chain, 0.5, fall(chain, dt))));

  problem_.v_before = J_ * chain.nu;
  problem_.vbar = J_ * nu_free_;
  for (Index i = 0; i < problem_.size(); ++i)
    problem_.vbar(3 * i) += rod.position_gain * std::min(0.0, beads[i].gap) / dt;
}

VectorXd joined_velocity(const BeadChain& chain) {
  return times_inertia(chain, -0.5, JointProjection(chain)(times_inertia(chain, 0.5, chain.nu)));
}

}  // namespace lcp
