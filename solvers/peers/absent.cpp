// The peers whose libraries were not found when this was configured, so that asking for one says
// which package it needs.

#include "solvers/registry.h"

namespace lcp {
namespace {

#ifndef LCPBENCH_HAS_SICONOS
const Absence siconos{
    {"siconos-lexicographic-lemke", "siconos-cao-ferris", "siconos-murty", "siconos-pathsearch",
     "siconos-newton-fb", "siconos-newton-minfb", "siconos-newton-min", "siconos-rpgs"},
    "Siconos",
    "libsiconos-numerics-dev"};
#endif
#ifndef LCPBENCH_HAS_BULLET
const Absence bullet{{"bullet-lemke", "bullet-dantzig"}, "Bullet", "libbullet-dev"};
#endif
#ifndef LCPBENCH_HAS_DART_KERNEL
const Absence dart_kernel{{"dart-dantzig"}, "DART's kernel", "libdart-external-odelcpsolver-dev"};
#endif
#ifndef LCPBENCH_HAS_DART
const Absence dart{{"dart-lemke", "dart-pgs"}, "DART", "libdart6.12"};
#endif

}  // namespace
}  // namespace lcp
