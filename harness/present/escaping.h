#pragma once

#include <string>

namespace lcp {

/// A value in quotes where CSV asks for them (RFC 4180).
std::string csv_quoted(const std::string& value);

/// Text with LaTeX's special characters escaped.
std::string latex_escaped(const std::string& text);

/// Text as it stands in HTML, between tags or in a quoted attribute.
std::string html_escaped(const std::string& text);

}  // namespace lcp
