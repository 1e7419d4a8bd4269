#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "harness/present/figure.h"

namespace lcp {

/// What a study says of itself, in every format; whoever asked for it prints or writes it.
struct Described {
  std::string text = {};  ///< For a terminal.
  std::string csv = {};
  nlohmann::ordered_json json = {};
  Figure figure = {};
};

}  // namespace lcp
