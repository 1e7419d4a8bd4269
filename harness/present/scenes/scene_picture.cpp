#include "harness/present/scenes/scene_picture.h"

#include "harness/present/gnuplot_page.h"
#include "harness/present/scenes/scene_panels.h"

namespace lcp {

void draw_picture(const NamedScene& scene, const std::vector<Snapshot>& snapshots,
                  const std::filesystem::path& svg) {
  const ScenePanels panels(scene, snapshots, {});
  const double width = panels.width(), height = panels.height();
  draw_with_gnuplot(svg, {.title = "A simulated scene, drawn by lcpbench simulate --picture.",
                          .width = width,
                          .height = height,
                          .commands = panels.script(width, height),
                          .data = panels.data()});
}

}  // namespace lcp
