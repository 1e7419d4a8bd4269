#!/usr/bin/env bash
# build_and_solve.sh LCPBENCH FOLDER COMPILER GENERATOR: configures, builds and runs the project beside
# this script in FOLDER, made anew, as if only what the solvers need were installed.
set -euo pipefail
hidden=()
for package in GTest benchmark HDF5 CLI11 nlohmann_json OpenSSL; do
  hidden+=(-D "CMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
rm -rf "$2"
cmake -S "$(dirname "$0")" -B "$2" -G "$4" -D LCPBENCH="$1" -D CMAKE_CXX_COMPILER="$3" \
  --no-warn-unused-cli -D CMAKE_BUILD_TYPE=Debug "${hidden[@]}" >/dev/null
cmake --build "$2" --target solve_one >/dev/null
"$2/solve_one" best-first
