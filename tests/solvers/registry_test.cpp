#include "solvers/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace lcp {
namespace {

/// Names in `const Registration x{{"name",` of every file of solvers/methods.
std::set<std::string> names_in_method_files() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(METHODS_FOLDER)) {
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t before = names.size();
    for (std::size_t at = 0; (at = text.find("const Registration ", at)) != text.npos;) {
      const std::size_t open = text.find('"', at), close = text.find('"', open + 1);
      names.insert(text.substr(open + 1, close - open - 1));
      at = close;
    }
    EXPECT_GT(names.size(), before) << entry.path() << " registers no row";
  }
  return names;
}

TEST(Registry, HoldsEveryRowOfEveryMethodFile) {
  std::set<std::string> registered;
  for (const Row& row : registry()) registered.insert(row.info.name);
  EXPECT_EQ(registered, names_in_method_files());
}

TEST(Registry, IsSortedByName) {
  EXPECT_TRUE(std::is_sorted(registry().begin(), registry().end(),
                             [](const Row& a, const Row& b) { return a.info.name < b.info.name; }));
}

TEST(Registry, EveryRowSaysWhatItIsAndWhereItComesFrom) {
  for (const Row& row : registry()) {
    EXPECT_FALSE(row.info.summary.empty()) << row.info.name;
    EXPECT_FALSE(row.info.source.empty()) << row.info.name;
    for (const Option& option : row.make()->options())
      EXPECT_FALSE(option.doc.empty()) << row.info.name << ':' << option.name;
  }
}

TEST(Registry, EveryRowTradesAccuracyForSpeedWithAnOptionWhoseLadderItAccepts) {
  for (const Row& row : registry()) {
    const std::unique_ptr<Solver> solver = row.make();
    Index ladders = 0;
    for (const Option& option : solver->options()) {
      ladders += option.accuracy_ladder.empty() ? 0 : 1;
      for (const std::string& value : option.accuracy_ladder)
        EXPECT_NO_THROW(option.set(value)) << row.info.name << ':' << option.name << '=' << value;
    }
    EXPECT_GT(ladders, 0) << row.info.name;
  }
}

TEST(Registry, FullSpellingNamesOnlyWhatDiffersFromTheDefaults) {
  EXPECT_EQ(make_solver("lexicographic:delta=1e-8").spelling, "lexicographic");
  EXPECT_EQ(make_solver("lexicographic:pivot=1e-10,delta=0.000001").spelling,
            "lexicographic:delta=1e-06,pivot=1e-10");
}

TEST(Registry, AFullSpellingMakesTheSameSolverAgain) {
  for (const Row& row : registry()) {
    const NamedSolver solver = make_solver(row.info.name);
    EXPECT_EQ(solver.spelling, row.info.name);
    EXPECT_EQ(make_solver(solver.spelling).spelling, solver.spelling);
  }
}

TEST(Registry, PatternsAndAllExpandInOrderWithoutRepetition) {
  const std::vector<NamedSolver> two = make_solvers({"lexicographic-revised", "lex*-revised"});
  ASSERT_EQ(two.size(), 1U);
  EXPECT_EQ(make_solvers({"all"}).size(), registry().size());
  EXPECT_EQ(make_solvers({"best-first*:epsilon=1e-4"}).front().spelling,
            "best-first:epsilon=0.0001");
}

TEST(Registry, RefusesUnknownNamesWithTheListOfRows) {
  for (const std::string name : {"lemkee", "x*"}) {
    try {
      make_solvers({name});
      FAIL() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("lexicographic-pivot"), std::string::npos);
    }
  }
}

TEST(Registry, SaysWhatAnAbsentPeerNeeds) {
  const Absence absence({"made-up-peer"}, "Made Up", "libmade-up-dev");
  for (const std::string name : {"made-up-peer", "made-*", "made-up-peer:scale=on"}) {
    try {
      make_solvers({name});
      FAIL() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("libmade-up-dev"), std::string::npos) << message;
      EXPECT_EQ(message.find("lexicographic"), std::string::npos) << message;
    }
  }
}

Row made_up_row(const std::string& name, InSuites in_suites) {
  return {{.name = name, .summary = "s", .source = "s", .in_suites = std::move(in_suites)}, {}};
}

TEST(Registry, SuitesRunANewRowAsItIsAfterTheOthersUnlessItSaysOtherwise) {
  Row peer = made_up_row("a-peer", {});
  peer.info.outside_library = "Made Up 1";
  EXPECT_EQ(
      rows_in_suites({made_up_row("a-new-row", {}), find_row("best-first"), find_row("lemke"), peer,
                      made_up_row("on-demand", {.settings = {}}),
                      made_up_row("twice", {.settings = {"k=1", "k=2"}, .place = 1})}),
      (std::vector<std::string>{"lemke", "twice:k=1", "twice:k=2", "best-first", "a-new-row"}));
  EXPECT_EQ(rows_in_suites(), rows_in_suites(registry()));
}

TEST(Registry, OwnStandsForEveryRowButThePeers) {
  const Index before = static_cast<Index>(make_solvers({"own"}).size());
  RowInfo info{.name = "zz-peer", .summary = "s", .source = "s"};
  info.outside_library = "Made Up 1";
  struct None {};
  static const Registration peer(
      info, None{}, [](None&) { return OptionTable{}; },
      [](const Problem&, const None&, const Call&) { return Result{}; });
  EXPECT_EQ(static_cast<Index>(make_solvers({"own"}).size()), before);
  EXPECT_EQ(static_cast<Index>(make_solvers({"all"}).size()), before + 1);
}

}  // namespace
}  // namespace lcp
