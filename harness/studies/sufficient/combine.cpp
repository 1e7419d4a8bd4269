#include "harness/studies/sufficient/combine.h"

#include <algorithm>

namespace lcp {

namespace {

bool saves_more(double saved, double than, double noise) {
  return 1 - saved < (1 - than) * (1 - noise);
}

}  // namespace

void combine(std::size_t axes, std::vector<SingleRung> singles, double noise,
             const std::function<Worth(const Rungs&)>& simulate) {
  std::erase_if(singles, [&](const SingleRung& single) {
    return !single.worth.passes || single.worth.saved < -noise;
  });
  if (singles.empty()) return;
  std::stable_sort(singles.begin(), singles.end(), [](const SingleRung& a, const SingleRung& b) {
    return a.worth.saved > b.worth.saved;
  });

  Rungs together(axes, 0), found(axes, 0);
  int varied = 0;
  for (const SingleRung& single : singles) {
    if (together[single.axis] != 0 || !saves_more(single.worth.saved, 0, noise)) continue;
    together[single.axis] = single.rung;
    ++varied;
  }
  Worth best{false, 0};
  if (varied > 1) best = simulate(together);
  if (best.passes) {
    found = together;
  } else {
    found[singles.front().axis] = singles.front().rung;
    best = singles.front().worth;
  }

  for (const SingleRung& single : singles) {
    if (found[single.axis] != 0) continue;
    Rungs tried = found;
    tried[single.axis] = single.rung;
    if (tried == together) continue;  // It failed.
    const Worth worth = simulate(tried);
    if (!worth.passes || !saves_more(worth.saved, best.saved, noise)) continue;
    found = tried;
    best = worth;
  }
}

}  // namespace lcp
