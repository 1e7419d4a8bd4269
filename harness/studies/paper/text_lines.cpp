#include "harness/studies/paper/text_lines.h"

#include <fmt/format.h>

#include <algorithm>

namespace lcp {

namespace {

constexpr std::size_t row_width = 22, line_width = 12;
constexpr std::size_t cell_width = 10;  ///< With its mark.

/// A heading cut after hyphens, commas, colons and at spaces into pieces that fit a cell.
Words broken(const std::string& heading) {
  constexpr std::size_t most = cell_width - 2;
  Words words{""};
  for (const char c : heading) {
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
    if (c == '-' || c == ',' || c == ':') words.emplace_back();
  }
  Words lines;
  for (const std::string& word : words) {
    if (word.empty()) continue;
    const bool follows_hyphen =
        !lines.empty() && std::string("-,:").find(lines.back().back()) != std::string::npos;
    if (follows_hyphen && lines.back().size() + word.size() <= most)
      lines.back() += word;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace

std::string heading_lines(const Words& headings) {
  std::vector<Words> all;
  std::size_t height = 0;
  for (const std::string& heading : headings) {
    all.push_back(broken(heading));
    height = std::max(height, all.back().size());
  }
  std::string out;
  for (std::size_t k = 0; k < height; ++k) {
    out += std::string(row_width + line_width, ' ');
    for (const Words& lines : all) {
      const std::size_t above = height - lines.size();
      out += fmt::format("{:>{}} ", k < above ? "" : lines[k - above], cell_width - 1);
    }
    out.erase(out.find_last_not_of(' ') + 1);
    out += '\n';
  }
  return out;
}

std::string text_line(const std::string& row, const std::string& label, const Words& cells) {
  std::string out = fmt::format("{:<{}}{:<{}}", row, row_width, label, line_width);
  for (const std::string& cell : cells) out += fmt::format("{:>{}}", cell, cell_width);
  out.erase(out.find_last_not_of(' ') + 1);
  return out + '\n';
}

std::string cell_text(const PaperQuantity& quantity, const PaperCell& cell) {
  return cell.value ? printed(quantity, *cell.value) + (cell.far ? "*" : " ") : "- ";
}

std::string row_text(const PaperQuantity& quantity, const std::vector<PaperLine>& lines,
                     std::size_t first, std::size_t last) {
  std::string out, label = quantity.label;
  for (const PaperLine& each : lines) {
    Words cells;
    bool any = false;
    for (std::size_t i = first; i < last; ++i) {
      cells.push_back(cell_text(quantity, each.cells[i]));
      any = any || each.cells[i].value;
    }
    if (!any) continue;
    out += text_line(label, each.label, cells);
    label.clear();
  }
  return out;
}

}  // namespace lcp
