#pragma once

#include <map>
#include <string>

#include "harness/studies/table/table.h"

namespace lcp::cli {

/// Values of --format.
const std::map<std::string, TableFormat>& table_formats();

/// The format that --format and the flag --json, which stands for --format json, ask for.
TableFormat chosen_format(const std::string& format, bool json);

}  // namespace lcp::cli
