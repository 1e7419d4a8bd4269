#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/attachments.h"

namespace lcp {

/// Script and style of the page, embedded at build time (harness/report/bundle).
std::string_view report_script();
std::string_view report_style();

/// One HTML page that opens from disk and fetches nothing (its content security policy forbids it):
/// `data` (see report_data) as a block of JSON, the script that draws it, and the attachments.
/// Whatever names, messages and texts hold, they are shown and never read as HTML.
std::string report_page(const nlohmann::ordered_json& data,
                        const std::vector<Attachments>& attachments);

/// JSON that may stand in a <script> element: no '<' is left in it, and bytes that are not UTF-8 are
/// replaced by U+FFFD.
std::string json_for_script(const nlohmann::ordered_json& data);

}  // namespace lcp
