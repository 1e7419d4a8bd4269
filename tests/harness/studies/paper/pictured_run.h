#pragma once

#include <stdlib.h>

#include <atomic>
#include <string>
#include <vector>

#include "harness/present/scenes/snapshots.h"
#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// A simulation with the frames that were wanted of it.
struct PicturedRun {
  NamedScene scene;
  LoopRun run;
  std::vector<Snapshot> snapshots;
};

/// The first `duration` (s) of a scene, with the search in the loop.
inline PicturedRun pictured(const std::string& spelling, double duration,
                            const std::vector<double>& times) {
  PicturedRun made{make_scene(spelling), {}, {}};
  made.scene.setup.duration = duration;
  Snapshots snapshots(times, made.scene.setup.stepping.dt, duration);
  const std::atomic<bool> interrupted = false;
  made.run = run_in_the_loop(
      made.scene, make_solver("best-first"), {},
      [&](const Simulation&, const Frame& frame, const FrameRecord&) { snapshots.look(frame); },
      interrupted);
  made.snapshots = snapshots.taken();
  return made;
}

/// Hides gnuplot, and whatever else is found through PATH, while it lives.
class WithoutGnuplot {
 public:
  explicit WithoutGnuplot(const std::string& empty_directory) : path_(std::getenv("PATH")) {
    setenv("PATH", empty_directory.c_str(), 1);
  }
  ~WithoutGnuplot() { setenv("PATH", path_.c_str(), 1); }
  WithoutGnuplot(const WithoutGnuplot&) = delete;
  WithoutGnuplot& operator=(const WithoutGnuplot&) = delete;

 private:
  std::string path_;
};

}  // namespace lcp
