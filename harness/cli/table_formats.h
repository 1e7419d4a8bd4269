#pragma once

#include <map>
#include <string>

#include "harness/studies/table/table.h"

namespace lcp::cli {

/// What --format takes.
const std::map<std::string, TableFormat>& table_formats();

/// What --format and the flag --json, which stands for --format json, say together.
TableFormat chosen_format(const std::string& format, bool json);

}  // namespace lcp::cli
