#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "harness/report/attachments.h"
#include "harness/report/origin_command.h"
#include "harness/report/report_data.h"
#include "harness/report/report_page.h"
#include "harness/studies/suites.h"
#include "harness/studies/table/table.h"
#include "problems/io/errors.h"
#include "tests/harness/made_up_records.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using Ordered = nlohmann::ordered_json;

constexpr const char* hostile = "</script><script>alert(1)</script>";

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// Two solvers on three instances of two corpora; one row says what it should not.
ReportedRun small_run() {
  ReportedRun run{.name = "small", .settings = RunSettings{}, .environments = {}, .rows = {}};
  run.settings->origin.suite = "small";
  run.environments = {{{"id", "0"}, {"commit", "c"}, {"dirty", false}, {"build_type", "Release"}}};
  Index place = 0;
  for (const char* instance : {"murty/0000", "murty/0001", "fathi:variant=2/0000"}) {
    for (const char* solver : {"lemke", "best-first:epsilon=1e-3"}) {
      run.rows.push_back(solved(instance, solver, 1e-10));
      run.rows.back().place = place;
    }
    ++place;
  }
  run.rows[3] = made_up("murty/0001", "best-first:epsilon=1e-3", Verdict::ray, Claim::ray, 1);
  run.rows[3].place = 1;
  run.rows[3].message = hostile;
  return run;
}

/// An entry of a list that may be stored once.
Ordered entry(const Ordered& list, std::size_t index) {
  return list.is_object() ? list.at("all") : list.at(index);
}

TEST(ReportData, HoldsEveryRowWithItsInstanceSolverAndVerdict) {
  const ReportedRun run = small_run();
  const Ordered data = report_data(run);
  const Ordered& rows = data.at("rows");
  ASSERT_EQ(rows.at("count"), run.rows.size());
  EXPECT_EQ(data.at("instances").size(), 3u);
  EXPECT_EQ(data.at("variants").size(), 2u);
  for (std::size_t i = 0; i < run.rows.size(); ++i) {
    const auto at = [&](const char* list, const char* column) {
      return data.at(list).at(entry(rows.at(column), i).get<std::size_t>());
    };
    EXPECT_EQ(at("instances", "instance").at("name"), run.rows[i].instance);
    EXPECT_EQ(at("variants", "variant").at("solver"), run.rows[i].solver);
    EXPECT_EQ(at("verdicts", "verdict").at("name"), to_string(run.rows[i].verdict));
    EXPECT_EQ(at("strings", "message"), run.rows[i].message);
    EXPECT_EQ(entry(rows.at("residual"), i), run.rows[i].accuracy->residual);
    EXPECT_EQ(entry(rows.at("work.pivots"), i), run.rows[i].work.pivots);
    EXPECT_EQ(entry(rows.at("median_ns"), i), 1'000'000);
  }
}

TEST(ReportData, KeepsListsInStepWhereARowHasNoAnswer) {
  ReportedRun run = small_run();
  run.rows[0] = ended("murty/0000", "lemke", Verdict::crash);
  run.rows[0].exit_signal = 6;
  run.rows[0].times_ns.clear();
  run.rows[5] = ended("fathi:variant=2/0000", "best-first:epsilon=1e-3", Verdict::timeout);
  run.rows[5].place = 2;
  const Ordered data = report_data(run);
  const Ordered& rows = data.at("rows");
  for (const char* column : {"residual", "zero_residual", "claim"}) {
    EXPECT_TRUE(entry(rows.at(column), 0).is_null()) << column;
    EXPECT_FALSE(entry(rows.at(column), 1).is_null()) << column;
    EXPECT_TRUE(entry(rows.at(column), 5).is_null()) << column;
  }
  EXPECT_EQ(entry(rows.at("signal"), 0), 6);
  EXPECT_TRUE(entry(rows.at("median_ns"), 0).is_null());
  EXPECT_EQ(entry(rows.at("median_ns"), 5), 1'000'000);
  for (const auto& [name, column] : rows.items()) {
    if (column.is_array()) {
      EXPECT_EQ(column.size(), run.rows.size()) << name;
    }
  }
}

TEST(ReportData, HoldsTheTableOfTheRunAndOfEveryOtherTolerance) {
  const ReportedRun run = small_run();
  const Ordered table = report_data(run).at("table");
  const Ordered& first = table.at("tolerances").front().at("columns");
  std::size_t own = 0;
  for (const Ordered& judged : table.at("tolerances")) {
    const double tolerance = judged.at("tolerance");
    own += judged.at("own") == true;
    const Table expected =
        judged.at("own") == true ? make_table(run.rows) : make_table(run.rows, tolerance);
    const Ordered rows = Ordered::parse(render(expected, TableFormat::json)).at("rows");
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [key, value] : rows[i].items())
        EXPECT_EQ(entry(judged.at("columns").value(key, first.value(key, Ordered())), i), value)
            << tolerance << " " << key;
  }
  EXPECT_EQ(own, 1u);
  EXPECT_EQ(table.at("tolerances").size(), report_tolerances().size());
}

TEST(ReportData, AddsTheRunsToleranceToTheLadder) {
  ReportedRun run = small_run();
  for (Record& row : run.rows) row.tolerance = 5e-7;
  const Ordered tolerances = report_data(run).at("table").at("tolerances");
  EXPECT_EQ(tolerances.size(), report_tolerances().size() + 1);
  EXPECT_TRUE(std::any_of(tolerances.begin(), tolerances.end(), [](const Ordered& each) {
    return each.at("tolerance") == 5e-7 && each.at("own") == true;
  }));
}

TEST(ReportData, JudgesAnewWhereRowsWereJudgedAtSeveralTolerances) {
  ReportedRun run = small_run();
  run.rows[0].tolerance = 1e-9;
  const Ordered data = report_data(run);
  for (const Ordered& each : data.at("table").at("tolerances")) EXPECT_EQ(each.at("own"), false);
  EXPECT_NE(data.at("notes").dump().find("several tolerances"), std::string::npos);
}

TEST(ReportNotes, SayWhatDisturbsTheNumbersAndNothingWhereNothingDoes) {
  ReportedRun run = small_run();
  EXPECT_TRUE(reading_notes(run).empty());
  run.rows[0].jobs = 2;
  run.rows[1].environment = "1";
  run.environments.front()["dirty"] = true;
  run.environments.front()["build_type"] = "Debug";
  run.settings.reset();
  run.rows.pop_back();
  const std::string notes = Ordered(reading_notes(run)).dump();
  for (const char* said : {"2 jobs", "2 environments", "changed tree", "Debug", "no run.json",
                           "1 pairs of an instance and a solver have no row"})
    EXPECT_NE(notes.find(said), std::string::npos) << said << notes;
}

TEST(ReportPage, ReadsNoNameMessageOrTextAsHtml) {
  ReportedRun run = small_run();
  run.name = hostile;
  run.rows[2].stderr_end = std::string("<!--<script>\xff") + hostile;
  const Attachments attached{hostile, {{hostile, hostile}}, {{hostile, hostile}}};
  const std::string page = report_page(report_data(run), {attached});
  EXPECT_EQ(occurrences(page, "</script>"), 2u);  // Of the data and of the page's own script.
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find("<!--"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(ReportPage, KeepsWhatItEscapesInJson) {
  const Ordered data = {{"message", hostile}, {"bytes", "a\xff"}};
  const std::string text = json_for_script(data);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Ordered::parse(text).at("message"), hostile);
  EXPECT_EQ(Ordered::parse(text).at("bytes"), "a\xEF\xBF\xBD");
}

TEST(ReportPage, CarriesItsScriptWhole) {
  EXPECT_EQ(report_script().find("</script"), std::string_view::npos);
  EXPECT_EQ(report_script().back(), '\n');
  EXPECT_NE(report_style().find("@media print"), std::string_view::npos);
}

TEST(ReportAttachments, AreThePicturesAndTextsOfADirectoryByName) {
  const TemporaryDirectory directory;
  for (const char* name : {"b.svg", "a.svg", "table.txt", "chart.gp"})
    write_text(directory.file(name), name);
  const Attachments found = read_attachments(directory.path());
  ASSERT_EQ(found.pictures.size(), 2u);
  EXPECT_EQ(found.pictures.front().name, "a.svg");
  ASSERT_EQ(found.texts.size(), 1u);
  EXPECT_EQ(found.texts.front().bytes, "table.txt");
  const TemporaryDirectory empty;
  EXPECT_THROW(read_attachments(empty.path()), UnreadableInput);
  EXPECT_THROW(read_attachments(empty.file("none")), UnreadableInput);
}

TEST(ReportAttachments, AreEncodedAsRfc4648Says) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(OriginCommand, QuotesWhateverTheShellWouldRead) {
  EXPECT_EQ(shell_quoted("lemke"), "'lemke'");
  EXPECT_EQ(shell_quoted("it's $(x)"), "'it'\\''s $(x)'");
}

TEST(OriginCommand, DrawsEveryFamilyOfEverySuiteWithTheCountOfTheSuite) {
  for (const Suite& suite : suites())
    for (const SuitePart& part : suite.parts) {
      if (!part.scene.empty()) continue;
      const std::string corpus = full_family_spelling(part.family);
      const auto draw = family_draw(suite.name, corpus);
      ASSERT_TRUE(draw) << suite.name << " " << part.family;
      if (part.count > 0) {
        EXPECT_EQ(draw->count, part.count);
      }
    }
  EXPECT_FALSE(family_draw("small", "stack"));
  EXPECT_FALSE(family_draw("none", "murty"));
  Origin origin;
  origin.suite = "default";
  const InstanceCommand command = origin_command("squat-like/0004", "squat-like", origin);
  EXPECT_EQ(command.before,
            "build/release/lcpbench generate 'squat-like' --count 200 --seed 1 --out "
            "replay-squat-like.hdf5 && ");
  EXPECT_EQ(command.where, "'replay-squat-like.hdf5#squat-like/0004'");
}

TEST(OriginCommand, NamesTheFileOfACorpusAndTriesEachOfSeveral) {
  Origin origin;
  origin.corpora = {"my file.hdf5"};
  EXPECT_EQ(origin_command("a/1", "a", origin).where, "'my file.hdf5#a/1'");
  origin.corpora = {"f.hdf5", "corpora/squat"};
  const InstanceCommand several = origin_command("a/1", "a", origin);
  EXPECT_EQ(several.before + several.where + several.after,
            "for f in 'f.hdf5' 'corpora/squat'/*; do \"$f\"'#a/1' && break; done");
  EXPECT_FALSE(several.note.empty());
  origin.corpora = {"f.hdf5#a/1", "f.hdf5#a/2"};
  EXPECT_EQ(origin_command("a/2", "a", origin).where, "'f.hdf5#a/2'");
}

TEST(OriginCommand, SaysWhenTheOriginIsUnknown) {
  const InstanceCommand command = origin_command("a/1", "a", {});
  EXPECT_EQ(command.where, "'FILE#a/1'");
  EXPECT_NE(command.note.find("does not say"), std::string::npos);
}

TEST(OriginCommand, SimulatesASceneUpToItsFrame) {
  const auto command = simulated_again("squat+composite/00040", "squat+composite");
  ASSERT_TRUE(command);
  EXPECT_NE(command->before.find("simulate 'squat' --duration"), std::string::npos);
  EXPECT_NE(command->before.find("--every 40"), std::string::npos);
  EXPECT_FALSE(simulated_again("squat-like/0004", "squat-like"));
  EXPECT_FALSE(simulated_again("squat/frame", "squat"));
  EXPECT_FALSE(simulated_again("squat:no-such-knob=1/00040", "squat:no-such-knob=1"));
  EXPECT_FALSE(simulated_again("squat", "squat"));
}

TEST(OriginCommand, NamesSolverAndStart) {
  Record record = solved("a/1", "lexicographic:delta=0", 0);
  EXPECT_EQ(solver_arguments(record), " --solver 'lexicographic:delta=0'");
  record.start = "two-step";
  EXPECT_EQ(solver_arguments(record), " --solver 'lexicographic:delta=0' --start 'two-step'");
}

}  // namespace
}  // namespace lcp
