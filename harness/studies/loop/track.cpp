#include "harness/studies/loop/track.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "problems/drawing/random.h"

namespace lcp {

namespace {

constexpr std::uint64_t kSeed = 1;  // of the disturbance

/// Collects the columns of a Track while a scene is simulated.
class Tracker {
 public:
  Tracker(const System& system, double dt, Track& track)
      : mechanism_(mechanisms(system.model)),
        dt_(dt),
        impulse_(VectorXd::Zero(
            3 * (mechanism_.empty()
                     ? 0
                     : 1 + *std::max_element(mechanism_.begin(), mechanism_.end())))),
        travel_(VectorXd::Zero(static_cast<Index>(system.handles.size()))),
        track_(track) {}

  void look(const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
    const System& system = simulation.system();
    const std::vector<Vector3d> centres = link_centres(system.model, frame.kinematics);
    VectorXd flat(3 * system.model.size());
    for (Index i = 0; i < system.model.size(); ++i) flat.segment<3>(3 * i) = centres[i];
    centres_.push_back(std::move(flat));
    impulses_.push_back(impulse_);
    travels_.push_back(travel_);
    scalars_.push_back({record.time, record.depth, record.energy,
                        record.contacts > 0 ? record.accuracy.residual
                                            : std::numeric_limits<double>::quiet_NaN()});
    for (std::size_t h = 0; h < system.handles.size(); ++h)
      impulse_.segment<3>(3 * mechanism_[system.handles[h]]) += dt_ * record.handle_forces[h];
    if (record.contacts > 0) add_slip(system, frame);
  }

  /// Writes what was collected into the track.
  void finish() {
    const Index frames = static_cast<Index>(scalars_.size());
    for (VectorXd* column : {&track_.time, &track_.depth, &track_.energy, &track_.residual})
      column->resize(frames);
    track_.centres.resize(frames > 0 ? centres_.front().size() : 0, frames);
    track_.impulse.resize(impulse_.size(), frames);
    track_.travel.resize(travel_.size(), frames);
    for (Index k = 0; k < frames; ++k) {
      track_.time(k) = scalars_[k].time;
      track_.depth(k) = scalars_[k].depth;
      track_.energy(k) = scalars_[k].energy;
      track_.residual(k) = scalars_[k].residual;
      track_.centres.col(k) = centres_[k];
      track_.impulse.col(k) = impulses_[k];
      track_.travel.col(k) = travels_[k];
    }
  }

 private:
  struct Scalars {
    double time, depth, energy, residual;
  };

  void add_slip(const System& system, const Frame& frame) {
    const FrictionBlocks& blocks = *frame.solution.frictional.friction;
    const VectorXd velocity = post_velocities(blocks, frame.solution.forces);
    VectorXd pressed = VectorXd::Zero(travel_.size()), rubbed = pressed;
    for (Index i = 0; i < blocks.contacts(); ++i) {
      const double normal = frame.solution.forces(3 * i);
      if (!(normal > 0)) continue;
      const ContactId& id = frame.contacts.contacts[i].id;
      for (const Index body : {id.body1, id.body2}) {
        if (body == 0) continue;
        const auto place = std::lower_bound(system.handles.begin(), system.handles.end(), body - 1);
        const Index handle = place - system.handles.begin();
        pressed(handle) += normal;
        rubbed(handle) += normal * velocity.segment<2>(3 * i + 1).norm();
      }
    }
    for (Index h = 0; h < travel_.size(); ++h)
      if (pressed(h) > 0) travel_(h) += dt_ * rubbed(h) / pressed(h);
  }

  std::vector<Index> mechanism_;
  double dt_;
  VectorXd impulse_, travel_;  ///< So far.
  std::vector<VectorXd> centres_, impulses_, travels_;
  std::vector<Scalars> scalars_;
  Track& track_;
};

std::vector<double> flat(const MatrixXd& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

nlohmann::json shaped(const MatrixXd& matrix) {
  return {{"rows", matrix.rows()}, {"cols", matrix.cols()}, {"values", flat(matrix)}};
}

MatrixXd matrix_from(const nlohmann::json& json) {
  const auto values = json.at("values").get<std::vector<double>>();
  MatrixXd matrix(json.at("rows").get<Index>(), json.at("cols").get<Index>());
  if (static_cast<Index>(values.size()) != matrix.size())
    throw std::invalid_argument("track: a matrix has another shape than it says");
  std::copy(values.begin(), values.end(), matrix.data());
  return matrix;
}

/// Every field with its name, for writing and reading.
template <class AnyTrack, class Plain, class Matrix>
void for_each_field(AnyTrack& track, Plain plain, Matrix matrix) {
  plain("scene", track.scene);
  plain("solver", track.solver);
  plain("dt", track.dt);
  plain("weight", track.weight);
  plain("broken", track.broken);
  plain("stopped", track.stopped);
  plain("contact_frames", track.contact_frames);
  plain("failed", track.failed);
  plain("n", track.n);
  plain("elapsed_s", track.elapsed_s);
  matrix("lcp_s", track.lcp_s);
  matrix("step_s", track.step_s);
  matrix("time", track.time);
  matrix("centres", track.centres);
  matrix("impulse", track.impulse);
  matrix("travel", track.travel);
  matrix("depth", track.depth);
  matrix("energy", track.energy);
  matrix("residual", track.residual);
}

void count(const LoopRun& run, Track& track) {
  double n = 0;
  track.lcp_s.resize(track.frames());
  track.step_s.resize(track.frames());
  for (Index k = 0; k < track.frames(); ++k) {
    const FrameRecord& frame = run.frames[k];
    track.lcp_s(k) = 1e-9 * static_cast<double>(frame.lcp_cpu_ns);
    track.step_s(k) = 1e-9 * static_cast<double>(frame.step_cpu_ns);
    if (frame.contacts == 0) continue;
    ++track.contact_frames;
    track.failed += frame.frictional != Verdict::solved;
    n += static_cast<double>(frame.n);
  }
  if (track.contact_frames > 0) track.n = n / static_cast<double>(track.contact_frames);
}

}  // namespace

std::vector<Index> mechanisms(const Model& model) {
  std::vector<Index> first(model.size());  // link of each one's mechanism
  for (Index i = 0; i < model.size(); ++i) {
    const Index parent = model.link(i).parent;
    first[i] = parent == Link::world ? i : first[parent];
  }
  for (const Loop& loop : model.loops()) {
    if (loop.link1 == Link::world) continue;
    const auto [low, high] = std::minmax(first[loop.link1], first[loop.link2]);
    std::replace(first.begin(), first.end(), Index{high}, Index{low});
  }
  std::vector<Index> numbers = first;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (Index& link : first)
    link = std::lower_bound(numbers.begin(), numbers.end(), link) - numbers.begin();
  return first;
}

void disturb_start(NamedScene& scene, double size) {
  Random random(kSeed);
  for (double& velocity : scene.setup.system.start.u) velocity += random.between(-size, size);
}

Track run_tracked(const NamedScene& scene, const NamedSolver& solver, const Acceptance& acceptance,
                  const std::function<void()>& beat, const std::atomic<bool>& interrupted,
                  std::optional<double> limit) {
  const System& system = scene.setup.system;
  Track track;
  Tracker tracker(system, scene.setup.stepping.dt, track);
  const auto begin = std::chrono::steady_clock::now();
  const LoopRun run = run_in_the_loop(
      scene, solver, acceptance,
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
        tracker.look(simulation, frame, record);
        beat();
      },
      interrupted, limit);
  track.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  tracker.finish();
  track.scene = run.scene;
  track.solver = run.solver;
  track.dt = run.dt;
  track.weight = system.model.mass() * system.gravity.norm();
  track.broken = run.broken;
  track.stopped = run.stopped;
  count(run, track);
  return track;
}

void to_json(nlohmann::json& json, const Track& track) {
  json = nlohmann::json::object();
  for_each_field(
      track, [&](const char* name, const auto& value) { json[name] = value; },
      [&](const char* name, const auto& value) { json[name] = shaped(value); });
}

void from_json(const nlohmann::json& json, Track& track) {
  for_each_field(
      track, [&](const char* name, auto& value) { json.at(name).get_to(value); },
      [&](const char* name, auto& value) { value = matrix_from(json.at(name)); });
}

}  // namespace lcp
