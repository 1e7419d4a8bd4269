#include "harness/record.h"
#include "harness/runs/rows.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();

Record example() {
  Record record;
  record.instance = "squat-like/0042";
  record.corpus = "squat-like";
  record.sha256 = std::string(64, 'a');
  record.n = 160;
  record.contacts = 16;
  record.active_contacts = 9;
  record.solver = "lexicographic:delta=1e-06";
  record.row = "lexicographic";
  record.version = "3";
  record.options = {{"delta", "1e-06"}, {"pivot", "0"}};
  record.start = "two-step";
  record.claim = Claim::ray;
  record.message = "nothing blocks z_3";
  record.verdict = Verdict::ray;
  record.unclaimed = true;
  record.trivial = true;
  record.tolerance = 1e-7;
  record.accuracy = Accuracy{.residual = 0.1,
                             .residual_unscaled = infinity,
                             .zero_residual = 1e-300,
                             .paper_error = std::numeric_limits<double>::quiet_NaN(),
                             .min_z = -infinity,
                             .min_w = -0.5,
                             .max_zw = 3,
                             .backward_error = 1.0 / 3};
  record.work = {.pivots = 1,
                 .path = 2,
                 .nodes = 3,
                 .generated = 4,
                 .largest_queue = 5,
                 .replayed = 6,
                 .factorisations = 7,
                 .sweeps = 8,
                 .start_pivots = 9,
                 .restarts = 10,
                 .frictionless_pivots = 11};
  record.z = Eigen::Vector3d(0, 1.0 / 3, 1e-300);
  record.times_ns = {300, 100, 200};
  record.exit_signal = 6;
  record.stderr_end = "last \"words\"\n";
  record.jobs = 2;
  record.environment = "0123456789ab";
  return record;
}

TEST(Record, ComesBackFromJsonWithEveryField) {
  const Record record = example();
  const Record back = json::parse(json(record).dump()).get<Record>();
  EXPECT_EQ(back.instance, record.instance);
  EXPECT_EQ(back.corpus, record.corpus);
  EXPECT_EQ(back.sha256, record.sha256);
  EXPECT_EQ(back.n, 160);
  EXPECT_EQ(back.contacts, 16);
  EXPECT_EQ(back.active_contacts, 9);
  EXPECT_EQ(back.solver, record.solver);
  EXPECT_EQ(back.row, record.row);
  EXPECT_EQ(back.version, "3");
  EXPECT_EQ(back.options, record.options);
  EXPECT_EQ(back.start, "two-step");
  EXPECT_EQ(back.claim, Claim::ray);
  EXPECT_EQ(back.message, record.message);
  EXPECT_EQ(back.verdict, Verdict::ray);
  EXPECT_TRUE(back.unclaimed);
  EXPECT_TRUE(back.trivial);
  EXPECT_EQ(back.tolerance, 1e-7);
  EXPECT_EQ(back.work.pivots, 1);
  EXPECT_EQ(back.work.path, 2);
  EXPECT_EQ(back.work.nodes, 3);
  EXPECT_EQ(back.work.generated, 4);
  EXPECT_EQ(back.work.largest_queue, 5);
  EXPECT_EQ(back.work.replayed, 6);
  EXPECT_EQ(back.work.factorisations, 7);
  EXPECT_EQ(back.work.sweeps, 8);
  EXPECT_EQ(back.work.start_pivots, 9);
  EXPECT_EQ(back.work.restarts, 10);
  EXPECT_EQ(back.work.frictionless_pivots, 11);
  EXPECT_TRUE(back.z == record.z);
  EXPECT_EQ(back.times_ns, record.times_ns);
  EXPECT_EQ(back.exit_signal, 6);
  EXPECT_EQ(back.stderr_end, record.stderr_end);
  EXPECT_EQ(back.jobs, 2);
  EXPECT_EQ(back.environment, record.environment);
}

TEST(Record, OfAnOlderProgramHasNoFrictionlessPivots) {
  json older = example();
  older["work"].erase("frictionless_pivots");
  EXPECT_EQ(older.get<Record>().work.frictionless_pivots, 0);
  older["work"].erase("restarts");
  EXPECT_THROW(older.get<Record>(), std::invalid_argument);
}

TEST(Record, KeepsEveryBitOfItsFiguresAndTheNonFiniteOnes) {
  const std::optional<Accuracy> back = json::parse(json(example()).dump()).get<Record>().accuracy;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->residual, 0.1);
  EXPECT_EQ(back->residual_unscaled, infinity);
  EXPECT_EQ(back->zero_residual, 1e-300);
  EXPECT_TRUE(std::isnan(back->paper_error));
  EXPECT_EQ(back->min_z, -infinity);
  EXPECT_EQ(back->min_w, -0.5);
  EXPECT_EQ(back->max_zw, 3);
  EXPECT_EQ(back->backward_error, 1.0 / 3);
}

TEST(Record, HasTheMedianOfItsSamples) {
  Record record = example();
  EXPECT_EQ(record.median_ns(), 200);
  EXPECT_EQ(json(record).at("median_ns"), 200);
  record.times_ns.clear();
  EXPECT_EQ(record.median_ns(), std::nullopt);
}

TEST(Record, HasNoClaimAndNoFiguresWhereThereWasNoAnswer) {
  Record record = example();
  record.accuracy.reset();
  for (const Verdict verdict :
       {Verdict::timeout, Verdict::memory, Verdict::crash, Verdict::not_run}) {
    record.verdict = verdict;
    const json object = record;
    EXPECT_FALSE(object.contains("claim"));
    EXPECT_FALSE(object.contains("accuracy"));
    EXPECT_EQ(object.get<Record>().verdict, verdict);
  }
}

TEST(Record, NamesTheFieldThatIsMissingOrMalformed) {
  const auto complaint = [](const json& object) -> std::string {
    try {
      object.get<Record>();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  const json whole = example();
  for (const auto& [name, value] : whole.items()) {
    const std::string quoted = "'" + name + "'";
    json malformed = whole, missing = whole;
    malformed[name] = json::array({json::object()});
    missing.erase(name);
    if (name != "median_ns" && name != "options") {  // Derived, and free in form.
      EXPECT_NE(complaint(malformed).find(quoted), std::string::npos) << complaint(malformed);
    }
    if (name != "median_ns" && name != "accuracy" && name != "active_contacts" && name != "place" &&
        name != "z") {  // Optional.
      EXPECT_NE(complaint(missing).find(quoted), std::string::npos) << complaint(missing);
    }
  }
  json object = whole;
  object["verdict"] = "splendid";
  EXPECT_NE(complaint(object).find("splendid"), std::string::npos);
  object = whole;
  object["schema"] = Record::schema + 1;
  EXPECT_NE(complaint(object).find("schema"), std::string::npos);
}

TEST(ReadRecords, ReturnsWhatWasWrittenInOrder) {
  const TemporaryDirectory directory;
  Record record = example();
  {
    RecordWriter writer(directory.path());
    writer.write(record);
    record.instance = "squat-like/0043";
    writer.write(record);
  }
  const std::vector<Record> records = read_records(directory.path());
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(json(records[0]), json(example()));
  EXPECT_EQ(records[1].instance, "squat-like/0043");
}

TEST(ReadRecords, DropsAnUnfinishedLastLine) {
  const TemporaryDirectory directory;
  const std::string line = json(example()).dump();
  for (const std::string& torn : {line.substr(0, line.size() / 2), line}) {
    write_text(directory.file("rows.jsonl"), line + "\n" + torn);
    EXPECT_EQ(read_records(directory.path()).size(), 1u);
  }
}

TEST(ReadRecords, NamesFileAndLineOfAMalformedRow) {
  const TemporaryDirectory directory;
  const std::string line = json(example()).dump() + "\n";
  for (const char* malformed : {"{\"schema\": 1}\n", "not json\n", "\n", "[1]\n"}) {
    write_text(directory.file("rows.jsonl"), line + malformed + line);
    try {
      read_records(directory.path());
      ADD_FAILURE() << malformed;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("rows.jsonl:2:"), std::string::npos) << error.what();
    }
  }
}

TEST(ReadRecords, ThrowsWithoutAFile) {
  const TemporaryDirectory directory;
  EXPECT_THROW(read_records(directory.path()), std::runtime_error);
}

TEST(RecordWriter, ContinuesAFileWhoseLastLineIsUnfinished) {
  const TemporaryDirectory directory;
  const std::string line = json(example()).dump();
  write_text(directory.file("rows.jsonl"), line + "\n" + line.substr(0, 30));
  RecordWriter(directory.path()).write(example());
  EXPECT_EQ(read_text(directory.file("rows.jsonl")), line + "\n" + line + "\n");
}

TEST(RecordWriter, ThrowsWhereItCannotCreateTheFile) {
  EXPECT_THROW(RecordWriter("/proc/no-such-directory"), std::system_error);
}

TEST(RecordWriter, ThrowsOnAFullDisk) {
  const TemporaryDirectory directory;
  std::filesystem::create_symlink("/dev/full", directory.file("rows.jsonl"));
  RecordWriter writer(directory.path());
  try {
    writer.write(example());
    FAIL() << "/dev/full took a row";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_space_on_device);
  }
}

/// The limit on file size stands for a disk that fills up in the middle of a row.
TEST(RecordWriter, CutsOffARowThatDidNotFit) {
  const TemporaryDirectory directory;
  RecordWriter writer(directory.path());
  writer.write(example());
  const std::string first = read_text(directory.file("rows.jsonl"));

  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit tight{first.size() + 100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  EXPECT_THROW(writer.write(example()), std::system_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  EXPECT_EQ(read_text(directory.file("rows.jsonl")), first);
  writer.write(example());
  EXPECT_EQ(read_records(directory.path()).size(), 2u);
}

TEST(RecordWriter, WritesOutputThatIsNotUtf8) {
  const TemporaryDirectory directory;
  Record record = example();
  record.stderr_end = "\xff binary";
  RecordWriter(directory.path()).write(record);
  EXPECT_EQ(read_records(directory.path()).at(0).stderr_end, "\xEF\xBF\xBD binary");
}

}  // namespace
}  // namespace lcp
