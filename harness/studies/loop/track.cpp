#include "harness/studies/loop/track.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "harness/fields.h"
#include "problems/drawing/random.h"

namespace lcp {

namespace {

constexpr std::uint64_t kSeed = 1;  // of the disturbance

/// A matrix as a track holds it in JSON: with its shape, which rows of a run leave out.
template <class Matrix>
struct Shaped {
  Matrix& matrix;
};

template <class Matrix>
void to_json(nlohmann::json& json, const Shaped<Matrix>& shaped) {
  const Matrix& m = shaped.matrix;
  json = {{"rows", m.rows()},
          {"cols", m.cols()},
          {"values", std::vector<double>(m.data(), m.data() + m.size())}};
}

template <class Matrix>
void from_json(const nlohmann::json& json, Shaped<Matrix>& shaped) {
  const auto values = json.at("values").get<std::vector<double>>();
  shaped.matrix.resize(json.at("rows").get<Index>(), json.at("cols").get<Index>());
  if (static_cast<Index>(values.size()) != shaped.matrix.size())
    throw std::invalid_argument("track: a matrix has another shape than it says");
  std::copy(values.begin(), values.end(), shaped.matrix.data());
}

constexpr auto track_fields = [](auto& track, const auto& field) {
  loop_header_fields(track, field);
  field("weight", track.weight);
  field("contact_frames", track.contact_frames);
  field("failed", track.failed);
  field("n", track.n);
  field("elapsed_s", track.elapsed_s);
  const auto shaped_field = [&field](const char* name, auto& matrix) {
    Shaped<std::remove_reference_t<decltype(matrix)>> shaped{matrix};
    field(name, shaped);
  };
  shaped_field("lcp_s", track.lcp_s);
  shaped_field("step_s", track.step_s);
  shaped_field("time", track.time);
  shaped_field("centres", track.centres);
  shaped_field("impulse", track.impulse);
  shaped_field("travel", track.travel);
  shaped_field("depth", track.depth);
  shaped_field("energy", track.energy);
  shaped_field("residual", track.residual);
};

/// Adds to the way that each handle has slipped what it slips in a frame.
void add_slip(const System& system, const Frame& frame, double dt, VectorXd& travel) {
  const FrictionBlocks& blocks = *frame.solution.frictional.friction;
  const VectorXd velocity = post_velocities(blocks, frame.solution.forces);
  VectorXd pressed = VectorXd::Zero(travel.size()), rubbed = pressed;
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
  for (Index h = 0; h < travel.size(); ++h)
    if (pressed(h) > 0) travel(h) += dt * rubbed(h) / pressed(h);
}

/// What the records of frames say, of which there are as many as columns.
void take_records(const System& system, const LoopRun& run, Track& track) {
  const Index frames = static_cast<Index>(run.frames.size());
  for (VectorXd* column :
       {&track.time, &track.depth, &track.energy, &track.residual, &track.lcp_s, &track.step_s})
    column->resize(frames);
  const std::vector<Index> mechanism = mechanisms(system.model);
  const Index count =
      mechanism.empty() ? 0 : 1 + *std::max_element(mechanism.begin(), mechanism.end());
  track.impulse.resize(3 * count, frames);
  VectorXd impulse = VectorXd::Zero(3 * count);  // so far
  double n = 0;
  for (Index k = 0; k < frames; ++k) {
    const FrameRecord& frame = run.frames[k];
    const bool touches = frame.contacts > 0;
    track.time(k) = frame.time;
    track.depth(k) = frame.depth;
    track.energy(k) = frame.energy;
    track.residual(k) =
        touches ? frame.accuracy.residual : std::numeric_limits<double>::quiet_NaN();
    track.lcp_s(k) = 1e-9 * static_cast<double>(frame.lcp_cpu_ns);
    track.step_s(k) = 1e-9 * static_cast<double>(frame.step_cpu_ns);
    track.impulse.col(k) = impulse;
    for (std::size_t h = 0; h < system.handles.size(); ++h)
      impulse.segment<3>(3 * mechanism[system.handles[h]]) += run.dt * frame.handle_forces[h];
    track.contact_frames += touches;
    track.failed += touches && frame.frictional != Verdict::solved;
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
  const Index handles = static_cast<Index>(system.handles.size());
  Track track;
  track.centres.resize(3 * system.model.size(), steps_to_make(scene));
  track.travel.resize(handles, steps_to_make(scene));
  VectorXd travel = VectorXd::Zero(handles);  // so far
  const auto begin = std::chrono::steady_clock::now();
  const LoopRun run = run_in_the_loop(
      scene, solver, acceptance,
      [&](const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
        const std::vector<Vector3d> centres = link_centres(system.model, frame.kinematics);
        for (Index i = 0; i < system.model.size(); ++i)
          track.centres.col(record.frame).segment<3>(3 * i) = centres[i];
        track.travel.col(record.frame) = travel;
        if (record.contacts > 0)
          add_slip(simulation.system(), frame, scene.setup.stepping.dt, travel);
        beat();
      },
      interrupted, limit);
  track.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  take_records(system, run, track);
  track.centres.conservativeResize(Eigen::NoChange, track.frames());
  track.travel.conservativeResize(Eigen::NoChange, track.frames());
  static_cast<LoopHeader&>(track) = run;
  track.weight = system.model.mass() * system.gravity.norm();
  return track;
}

void to_json(nlohmann::json& json, const Track& track) {
  json = fields_to_json(track, track_fields);
}

void from_json(const nlohmann::json& json, Track& track) {
  fields_from_json(json, track, track_fields, "track");
}

}  // namespace lcp
