#include "harness/measure/environment.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <openssl/crypto.h>
#include <openssl/sha.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <fstream>
#include <set>
#include <string>
#include <thread>

#include "harness/build_commit.h"  // Written by harness/build_commit.cmake at every build.
#include "solvers/registry.h"

namespace lcp {

namespace {

using nlohmann::json;

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

std::string frequency_governor() {
  std::ifstream file("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  std::string governor;
  return file >> governor ? governor : "unknown";
}

std::string kernel() {
  utsname system;
  if (uname(&system) != 0) return "unknown";
  return fmt::format("{} {} {}", system.sysname, system.release, system.machine);
}

json libraries() {
  return {{"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                              FMT_VERSION % 100)},
          {"glibc", gnu_get_libc_version()},
          {"hdf5", LCPBENCH_HDF5_VERSION},
          {"nlohmann_json", json::meta()["version"]["string"]},
          {"openssl", OpenSSL_version(OPENSSL_VERSION_STRING)}};
}

/// Libraries of the peers that are built in.
json peers() {
  std::set<std::string> libraries;
  for (const Row& row : registry())
    if (row.info.peer()) libraries.insert(row.info.outside_library);
  return libraries;
}

/// OpenBLAS, with the processor whose kernels it chose, where the program has loaded it, else null.
json blas() {
  using Text = char* (*)();
  const auto configuration = reinterpret_cast<Text>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
  if (!configuration) return {};
  return configuration();
}

std::string sha256(const std::string& text) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest);
  std::string hexadecimal;
  for (const unsigned char byte : digest) hexadecimal += fmt::format("{:02x}", byte);
  return hexadecimal;
}

}  // namespace

json describe_environment(int jobs) {
  json environment = {{"cpu", cpu_model()},
                      {"cores", std::thread::hardware_concurrency()},
                      {"governor", frequency_governor()},
                      {"kernel", kernel()},
                      {"compiler", LCPBENCH_COMPILER},
                      {"flags", LCPBENCH_FLAGS},
                      {"build_type", LCPBENCH_BUILD_TYPE},
                      {"commit", build_commit},
                      {"dirty", build_is_dirty ? json(*build_is_dirty) : json()},
                      {"libraries", libraries()},
                      {"peers", peers()},
                      {"blas", blas()},
                      {"jobs", jobs}};
  environment["id"] = sha256(environment.dump()).substr(0, 12);
  return environment;
}

}  // namespace lcp
