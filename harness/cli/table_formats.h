#pragma once

#include <map>
#include <string>

#include "harness/studies/table/table.h"

namespace lcp::cli {

/// Values of --format.
const std::map<std::string, TableFormat>& table_formats();

}  // namespace lcp::cli
