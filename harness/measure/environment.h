#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace lcp {

/// What a run's times and last bits depend on: cpu, cores, governor, kernel, compiler, flags, build
/// type, commit the program was built from and whether the tree differed from it (null where
/// unknown), library versions and `jobs`. "id" is the first 12 hexadecimal digits of the SHA-256 of
/// all the rest, so equal ids mean equal conditions. What the system does not tell is "unknown".
nlohmann::json describe_environment(int jobs);

}  // namespace lcp
