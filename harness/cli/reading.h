#pragma once

#include <CLI/CLI.hpp>

#include "problems/io/read_options.h"

namespace lcp::cli {

/// Adds --directions to the page of a verb that reads instances.
inline void add_reading_option(CLI::App& page, ReadOptions& reading) {
  page.add_option("--directions", reading.directions,
                  "Friction directions of contacts that come without them (FCLIB, Siconos); even")
      ->capture_default_str();
}

}  // namespace lcp::cli
