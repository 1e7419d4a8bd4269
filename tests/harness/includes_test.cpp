// The order of folders, read from the includes: an arrow against it fails here before it grows into a
// circle.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace lcp {
namespace {

namespace fs = std::filesystem;

/// Every place and what its files may include besides it: a place is the longest of these names that a
/// path begins with.
const std::map<std::string, std::vector<std::string>>& order() {
  static const auto all = [] {
    std::map<std::string, std::vector<std::string>> order = {
        {"solvers/", {}},
        {"solvers/linalg/", {"solvers/"}},
        {"solvers/methods/", {"solvers/", "solvers/linalg/"}},
        {"solvers/peers/", {"solvers/", "solvers/linalg/"}},
        {"problems/", {"solvers/"}},
        {"problems/drawing/", {"solvers/", "problems/"}},
        {"problems/contact/", {"solvers/", "problems/"}},
        {"problems/rigid/", {"solvers/", "problems/", "problems/contact/"}},
        {"problems/collision/", {"solvers/", "problems/contact/", "problems/rigid/"}},
        {"problems/io/", {"solvers/", "problems/", "problems/contact/"}},
        {"problems/families/",
         {"solvers/", "problems/", "problems/contact/", "problems/drawing/", "problems/rigid/"}},
        {"problems/scenes/",
         {"solvers/", "problems/", "problems/contact/", "problems/rigid/", "problems/collision/",
          "problems/io/"}}};
    // From the row up, each folder of the harness knows those before it; `present` knows no study, no run
    // and no row.
    std::vector<std::string> below;
    for (const auto& [place, unused] : order)
      if (place != "solvers/methods/" && place != "solvers/peers/") below.push_back(place);
    order["harness/present/"] = below;
    for (const char* place : {"harness/", "harness/judge/", "harness/measure/", "harness/runs/",
                              "harness/studies/", "harness/report/", "harness/cli/"}) {
      order[place] = below;
      below.push_back(place);
      if (place == std::string("harness/runs/")) below.push_back("harness/present/");
    }
    return order;
  }();
  return all;
}

std::string place_of(const std::string& path) {
  std::string longest;
  for (const auto& [place, unused] : order())
    if (path.starts_with(place) && place.size() > longest.size()) longest = place;
  return longest;
}

/// Whether a file at `from` may include `to`, both from the root of the tree.
bool may_include(const std::string& from, const std::string& to) {
  const std::string here = place_of(from), there = place_of(to);
  const std::vector<std::string>& known = order().at(here);
  return here == there || std::find(known.begin(), known.end(), there) != known.end();
}

struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> all = [] {
    std::vector<SourceFile> files;
    const fs::path root = SOURCE_DIR;
    for (const char* top : {"solvers", "problems", "harness"})
      for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        SourceFile file{fs::relative(entry.path(), root).generic_string(), {}};
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
        files.push_back(std::move(file));
      }
    return files;
  }();
  return all;
}

TEST(Includes, FollowTheOrderOfFolders) {
  const std::regex include(R"re(\s*#include "((solvers|problems|harness)/[^"]+)".*)re");
  std::size_t arrows = 0;
  for (const SourceFile& file : sources())
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      ++arrows;
      EXPECT_TRUE(may_include(file.path, match[1])) << file.path << " includes " << match[1];
    }
  EXPECT_GT(arrows, 500u) << "the includes were not found";
}

TEST(Includes, AnArrowAgainstTheOrderIsSeen) {
  EXPECT_FALSE(may_include("harness/record.h", "harness/judge/judge.h"));
  EXPECT_FALSE(may_include("harness/measure/runner.h", "harness/runs/rows.h"));
  EXPECT_FALSE(may_include("harness/runs/run_directory.h", "harness/studies/table/table.h"));
  EXPECT_FALSE(may_include("harness/present/figure.h", "harness/studies/sheet/sheet.h"));
  EXPECT_FALSE(may_include("harness/present/figure.h", "harness/record.h"));
  EXPECT_FALSE(may_include("harness/studies/suites.h", "harness/cli/verbs.h"));
  EXPECT_FALSE(may_include("solvers/methods/lemke.cpp", "problems/instance.h"));
  EXPECT_FALSE(may_include("problems/io/load.cpp", "harness/record.h"));
  EXPECT_FALSE(may_include("solvers/linalg/basis.cpp", "solvers/methods/lemke.cpp"));
}

TEST(Includes, NoTypeIsDefinedTwice) {
  // At the start of a line, in namespace lcp or lcp::{anonymous} of a header: what two files could mix
  // up. A .cpp keeps its own to itself.
  const std::regex definition(
      R"re((?:struct|class|enum class) (\w+)(?: final)?(?: :.*)?\s*\{.*)re");
  std::map<std::string, std::string> defined_in;
  for (const SourceFile& file : sources()) {
    if (!file.path.ends_with(".h")) continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_match(line, match, definition)) continue;
      const auto [first, added] = defined_in.emplace(match[1], file.path);
      EXPECT_TRUE(added) << match[1] << " is defined in " << first->second << " and " << file.path;
    }
  }
  EXPECT_GT(defined_in.size(), 100u) << "the definitions were not found";
}

}  // namespace
}  // namespace lcp
