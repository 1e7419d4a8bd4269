#include "harness/report/report_page.h"

#include <fmt/format.h>

#include "harness/present/escaping.h"
#include "harness/report/bundle.h"  // Written by embed_bundle.cmake at every change.

namespace lcp {

namespace {

/// Nothing is fetched, whatever the page holds.
constexpr const char* policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

std::string pictures_and_texts(const Attachments& attachments) {
  std::string out = fmt::format("<section class=\"attachments\"><h3>{}</h3>\n",
                                html_escaped(attachments.heading));
  for (const Attachments::File& picture : attachments.pictures)
    out += fmt::format(
        "<figure><img src=\"data:image/svg+xml;base64,{}\" alt=\"{}\">"
        "<figcaption>{}</figcaption></figure>\n",
        base64(picture.bytes), html_escaped(picture.name), html_escaped(picture.name));
  for (const Attachments::File& text : attachments.texts)
    out +=
        fmt::format("<details open><summary>{}</summary><pre tabindex=\"0\">\n{}</pre></details>\n",
                    html_escaped(text.name), html_escaped(text.bytes));
  return out + "</section>\n";
}

}  // namespace

std::string_view report_script() { return {report_script_bytes, report_script_size}; }
std::string_view report_style() { return {report_style_bytes, report_style_size}; }

std::string json_for_script(const nlohmann::ordered_json& data) {
  const std::string text =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";  // '<' stands in strings only.
    } else {
      out += c;
    }
  }
  return out;
}

std::string report_page(const nlohmann::ordered_json& data,
                        const std::vector<Attachments>& attachments) {
  const std::string name = html_escaped(data.at("name").get<std::string>());
  std::string attached;
  for (const Attachments& each : attachments) attached += pictures_and_texts(each);
  if (!attached.empty())
    attached = "<section id=\"pictures\"><h2>Pictures and other results</h2>\n" + attached +
               "</section>\n";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>lcpbench: {}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<div id=\"report\"><noscript>This page draws its tables and charts with a script, which is "
      "part of it.</noscript></div>\n"
      "{}"
      "<script type=\"application/json\" id=\"data\">{}</script>\n"
      "<script>\n{}</script>\n</body>\n</html>\n",
      policy, name, report_style(), attached, json_for_script(data), report_script());
}

}  // namespace lcp
