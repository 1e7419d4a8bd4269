#include "harness/present/gnuplot_page.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "harness/present/gnuplot.h"
#include "problems/io/replace_file.h"

namespace lcp {

void draw_with_gnuplot(const std::filesystem::path& svg, const GnuplotPage& page) {
  const std::filesystem::path gp = std::filesystem::path(svg).replace_extension(".gp");
  const std::filesystem::path dat = std::filesystem::path(svg).replace_extension(".dat");
  const std::string name = fit_for_gnuplot(svg.stem().string());
  if (name != svg.stem().string())
    throw std::invalid_argument(
        fmt::format("{}: expected a name without quotes and control characters", svg.string()));
  replace_file(dat.string(), page.data);
  std::string image;
  if (!page.image.empty()) {
    replace_file(std::filesystem::path(svg).replace_extension(".png").string(), page.image);
    image = fmt::format("IMAGE = '{}.png'\n", name);
  }
  replace_file(gp.string(),
               fmt::format(R"(# {title}
# To restyle: edit, then gnuplot {name}.gp > {name}.svg
DATA = '{name}.dat'
{image}set terminal svg size {width:.0f},{height:.0f} enhanced background '#ffffff' font 'sans-serif,12'
set datafile missing NaN
set multiplot
{commands}unset multiplot
)",
                           fmt::arg("title", fit_for_gnuplot(page.title)), fmt::arg("name", name),
                           fmt::arg("image", image), fmt::arg("width", page.width),
                           fmt::arg("height", page.height), fmt::arg("commands", page.commands)));
  run_gnuplot(gp, svg);
}

std::string gnuplot_margins(const PageArea& area, double page_width, double page_height) {
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
      area.left / page_width, (area.left + area.width) / page_width, 1 - area.top / page_height,
      1 - (area.top + area.height) / page_height);
}

std::string fit_for_gnuplot(std::string name) {
  for (char& c : name)
    if (std::iscntrl(static_cast<unsigned char>(c)) || c == '\'' || c == '"' || c == '`') c = '?';
  return name;
}

}  // namespace lcp
