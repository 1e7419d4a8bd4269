// Without friction W = W' >= 0 and the LCP says what Gauss' principle says: of all velocities at which
// nothing sinks, u+ is the nearest to u without contact forces, in the metric of the masses,
//
//     min 1/2 (u - u_free)' M (u - u_free)   subject to   J u + c >= 0.
//
// Here it is minimised over velocities, as a least-distance problem in x = L'(u - u_free), M = L L',
// which knows nothing of forces or of W.

#include <gtest/gtest.h>

#include "problems/scenes/scene.h"
#include "tests/problems/rigid/dynamics_cases.h"
#include "tests/problems/rigid/joint_coordinates.h"
#include "tests/problems/rigid/least_distance.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;

/// Velocities that contacts gain from x: rows of J L^-T of the normals.
MatrixXd normal_map(const Model& model, const Kinematics& k, const std::vector<Index>& handles,
                    const LinkContacts& contacts) {
  const cases::JointCoordinates d = cases::joint_coordinates(model, k, Vector3d::Zero());
  const std::vector<Index>& u = d.free_velocities;
  MatrixXd Jh(6 * handles.size(), u.size());
  for (std::size_t h = 0; h < handles.size(); ++h)
    Jh.middleRows<6>(6 * h) = d.J[handles[h]](Eigen::all, u);
  const MatrixXd J = contacts.J * Jh;
  std::vector<Index> normals;
  for (Index i = 0; i < J.rows() / 3; ++i) normals.push_back(3 * i);
  const Eigen::LLT<MatrixXd> factor(MatrixXd(d.M(u, u)));
  const MatrixXd transposed = factor.matrixL().solve(MatrixXd(J(normals, Eigen::all).transpose()));
  return transposed.transpose();
}

/// Compares what solvers say of the frictionless LCP of these contacts with the optimum over
/// velocities.
void expect_optimum(const ContactProblem& problem, const MatrixXd& G) {
  const Problem lcp = frictionless_lcp(problem);
  const double fast = lcp.q.cwiseAbs().maxCoeff();
  const VectorXd x = cases::least_distance(G, -lcp.q / fast) * fast;
  const VectorXd w = G * x + lcp.q;
  ASSERT_GE(w.minCoeff(), -1e-9 * fast) << "the optimum lets nothing sink";
  // lexicographic-revised takes rows within delta = 1e-8 for tied, and some such pivots may end a few
  // times that far off.
  for (const auto& [name, tolerance] :
       {std::pair("best-first", 1e-9), {"lexicographic-revised", 1e-7}}) {
    const Result result = make_solver(name).solver->solve(lcp, {});
    ASSERT_EQ(result.claim, Claim::solved) << name;
    const VectorXd found = lcp.M * result.z + lcp.q;
    EXPECT_LE(record(std::string("w, ") + name, (found - w).cwiseAbs().maxCoeff() / fast),
              tolerance);
    // x = dt L^-1 J' a, so that |x|^2 = dt a'W a.
    const double energy = result.z.dot(lcp.M * result.z) * problem.dt;
    EXPECT_NEAR(energy, x.squaredNorm(), tolerance * x.squaredNorm()) << name;
  }
}

TEST(FrictionlessOptimum, OfATreeThatTouchesTheWorldAndItself) {
  const auto tree = [](cases::Uniform& uniform) {
    return cases::random_model(
        {.joints = {JointKind::revolute, JointKind::ball}, .second_root = true}, uniform);
  };
  Index pressed = 0;
  for (const std::uint64_t seed : {111, 112, 113, 114}) {
    const cases::Situation s({"Tree", tree, 4, seed});
    const Kinematics k = s.kinematics();
    cases::Uniform uniform(seed + 10);
    std::vector<ContactPoint> points(8);
    for (Index i = 0; i < 8; ++i) {
      points[i].position = s.origin + cases::random_vector(uniform);
      points[i].normal = cases::random_vector(uniform).normalized();
      points[i].id = {body_of(s.handles[i % 4]), i < 4 ? 0 : body_of(s.handles[(i + 1) % 4]), i};
    }
    const LinkContacts contacts = link_contacts(points, 0, k, s.handles);
    ForwardDynamics dynamics(s.model, s.handles);
    dynamics.assemble(k, s.torques, s.gravity);
    const ContactProblem problem = contact_problem(contacts, dynamics.handle_dynamics(), 1e-3, {});
    const Problem lcp = frictionless_lcp(problem);
    pressed += (lcp.q.array() < 0).count();
    expect_optimum(problem, normal_map(s.model, k, s.handles, contacts));
  }
  EXPECT_GE(pressed, 8) << "there is something to find";
}

TEST(FrictionlessOptimum, OfTheRobotOnSixteenPointsOfWhichThreeSuffice) {
  // Forces are not unique: the normal part of W has rank 3. Velocities are, on the composite body's W;
  // the noise of the assembled one (1e-10) moves them by up to 4e-9 where 13 forces are spread widely.
  const NamedScene scene = make_scene("squat:mu=0");
  Simulation simulation(scene.setup.system, scene.setup.stepping);
  Index frames = 0;
  cases::run(simulation, 0.06, cases::solver_in_the_loop(), [&](const Frame& frame) {
    if (frame.number % 10 != 5 || frame.points.empty()) return;
    ++frames;
    expect_optimum(simulation.clean_contacts(frame),
                   normal_map(scene.setup.system.model, frame.kinematics,
                              scene.setup.system.handles, frame.links));
  });
  EXPECT_GE(frames, 3);
}

}  // namespace
}  // namespace lcp
