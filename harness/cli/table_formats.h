#pragma once

#include <map>
#include <string>

#include "harness/tables/table.h"

namespace lcp::cli {

/// What --format takes.
const std::map<std::string, TableFormat>& table_formats();

}  // namespace lcp::cli
