#pragma once

#include <string>
#include <vector>

namespace lcp {

/// What is wrong with the nesting of an XML text's elements; empty where nothing is. Enough of XML for
/// what gnuplot writes.
inline std::string complaint_about_xml(const std::string& text) {
  std::vector<std::string> open;
  bool had_root = false;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      if (at == std::string::npos) return "a comment does not end";
      continue;
    }
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag does not end";
    const std::string tag = text.substr(at + 1, end - at - 1);
    at = end;
    if (tag.empty() || tag.find('<') != std::string::npos) return "a tag in a tag: " + tag;
    if (tag[0] == '?' || tag[0] == '!') continue;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "closes nothing: " + tag;
      open.pop_back();
    } else if (tag.back() != '/') {
      if (open.empty() && had_root) return "a second root: " + tag;
      had_root = true;
      open.push_back(tag.substr(0, tag.find_first_of(" \t\n")));
    }
  }
  if (!open.empty()) return "never closed: " + open.back();
  return had_root ? "" : "no element";
}

}  // namespace lcp
