#include "harness/cli/table_formats.h"

namespace lcp::cli {

const std::map<std::string, TableFormat>& table_formats() {
  static const std::map<std::string, TableFormat> all = {{"text", TableFormat::text},
                                                         {"csv", TableFormat::csv},
                                                         {"json", TableFormat::json},
                                                         {"latex", TableFormat::latex}};
  return all;
}

}  // namespace lcp::cli
