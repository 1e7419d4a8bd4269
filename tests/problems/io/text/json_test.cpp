#include "problems/io/text/json.h"

#include <gtest/gtest.h>

#include "problems/io/errors.h"
#include "tests/problems/cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

class JsonInstances : public testing::Test {
 protected:
  std::vector<Instance> read(const std::string& text) {
    files::put(path, text);
    return read_json(path, "stem");
  }
  std::string complaint(const std::string& text) {
    const std::string message = files::message_of<UnreadableInput>([&] { read(text); });
    return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
  }

  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.json");
};

TEST_F(JsonInstances, GiveBackEveryBit) {
  Instance options = make_instance("options", cases::plain_with_all_options(),
                                   {{"note", "two\nlines, \xC3\xA9"}, {"", ""}});
  options.known_solution = VectorXd{{-0.0, 2e-300}};
  options.previous = Start{};  // of an empty basis, without a point
  Instance contacts = make_instance("frames/1", cases::with_contacts(), {});
  contacts.active_contacts = 1;
  contacts.previous = cases::previous_of_contacts();
  Problem empty;
  set_plain_scales(empty);
  const std::vector<Instance> written = {options, contacts, make_instance("empty", empty, {})};
  write_json(path, written);
  const std::vector<Instance> read = read_json(path, "stem");
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) expect_same(written[i], read[i]);
}

TEST_F(JsonInstances, NeedOnlyMAndQ) {
  const Instance instance = read(R"({"q": [-5, -6.5], "M": [[2, 1], [3, 4e0]]})").front();
  EXPECT_EQ(instance.name, "stem");
  Problem expected;
  expected.M = MatrixXd{{2, 1}, {3, 4}};
  expected.q = VectorXd{{-5, -6.5}};
  set_plain_scales(expected);
  EXPECT_EQ(instance.sha256, content_hash(expected));
  const std::string one = R"({"M": [[1]], "q": [-1]})";
  const std::vector<Instance> two = read("{\"instances\": [" + one + ", " + one + "]}");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[1].name, "stem/1");
}

TEST_F(JsonInstances, NameThePlaceOfWhatIsWrong) {
  const auto second = [](const std::string& instance) {
    return R"({"instances": [{"name": "a", "M": [[1]], "q": [1]}, )" + instance + "]}";
  };
  EXPECT_EQ(complaint(second(R"({"M": [[1, 2], [3]], "q": [1, 2]})")),
            "/instances/1/M/1: has 1 entries, expected 2");
  EXPECT_EQ(complaint(second(R"({"M": [[1, 2]], "q": [1, 2]})")),
            "/instances/1/M: has 1 entries, expected 2 as q");
  EXPECT_EQ(complaint(second(R"({"M": [["1"]], "q": [1]})")),
            "/instances/1/M/0/0: is string, expected a number");
  EXPECT_EQ(complaint(second(R"({"M": [[1]], "q": [null]})")),
            "/instances/1/q/0: is null, expected a number");
  EXPECT_EQ(complaint(second(R"({"M": [[1]]})")), "/instances/1/q: is missing");
  EXPECT_EQ(complaint(second("7")), "/instances/1: is number, expected an object");
  EXPECT_EQ(complaint(second(R"({"name": "a", "M": [[1]], "q": [1]})")),
            "/instances/1: is called 'a' like another, expected different names");
  EXPECT_EQ(complaint(R"({"M": [[1]], "q": [1], "s_z": [0]})"),
            "/: stem: s_z(0) is 0, expected a positive number");
  EXPECT_EQ(complaint(R"({"M": [[1]], "q": [1], "pivot_limit": 1.5})"),
            "/pivot_limit: is number, expected a whole number");
  EXPECT_EQ(complaint(R"({"M": [[1]], "q": [1], "known_solution": []})"),
            "/known_solution: has 0 entries, expected 1");
  EXPECT_EQ(complaint(R"({"M": [[1]], "q": [1], "provenance": {"a": 1}})"),
            "/provenance/a: is number, expected a text");
  EXPECT_EQ(complaint(R"({"instances": []})"),
            "/instances: holds no instance, expected at least 1");
  EXPECT_TRUE(complaint(R"({"M": [[1]], "q": [1], "s_Z": [1]})")
                  .starts_with("/: has the unknown key 's_Z', expected M, active_contacts, c, "));
}

TEST_F(JsonInstances, ComplainOfAHashThatDoesNotFit) {
  write_json(path, {make_instance("a", cases::plain(), {})});
  std::string text = files::content(path);
  text.replace(text.find("0.7"), 3, "0.8");
  EXPECT_TRUE(complaint(text).starts_with("/instances/0/sha256: is ")) << complaint(text);
}

TEST_F(JsonInstances, ComplainOfAPreviousSolutionThatIsNone) {
  const auto with = [&](const std::string& previous) {
    return complaint(R"({"M": [[1, 0], [0, 1]], "q": [-1, -1], )" + previous + "}");
  };
  EXPECT_EQ(with(R"("previous_alpha": [1, 0])"),
            "/: previous solution: alpha holds row 0 behind row 1, expected ascending rows");
  EXPECT_EQ(with(R"("previous_alpha": [0], "previous_z": [1])"),
            "/: previous solution: z has 1 entries, expected 2 or none");
  EXPECT_TRUE(with(R"("previous_alpha": [0], "previous_sha256": "0")")
                  .starts_with("/previous_sha256: is 0, but the content has "));
}

TEST_F(JsonInstances, ComplainOfRowsThatNoIntegerCanCountTo) {
  write_json(path, {make_instance("a", cases::with_contacts(), {})});
  std::string text = files::content(path);
  const std::string rows = "\"friction_row\":[";
  text.replace(text.find(rows) + rows.size(), 1, "9223372036854775807");
  EXPECT_EQ(complaint(text),
            "/instances/0: a: friction_row of contact 0 is 9223372036854775807, expected 0 ... 3");
}

TEST_F(JsonInstances, ComplainInOneLineOfWhatIsNoJson) {
  for (const std::string text :
       {"", "{", "[1, 2", "{\"M\": [[NaN]], \"q\": [1]}", "{\"M\": [[1e999]], \"q\": [1]}",
        "nonsense\n\x01\xFF", "{\"M\": [[1]], \"q\": [1]} 5"}) {
    files::put(path, text);
    const std::string message =
        files::message_of<UnreadableInput>([&] { read_json(path, "stem"); });
    EXPECT_TRUE(message.starts_with(path + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(JsonInstances, RefuseNestingBeforeItFillsTheStack) {
  constexpr std::size_t depth = 1'000'000;
  EXPECT_EQ(complaint(std::string(depth, '[')), "is nested deeper than 6, expected instances");
  std::string objects;
  for (int i = 0; i < 1000; ++i) objects += "{\"a\":";
  EXPECT_EQ(complaint(objects), "is nested deeper than 6, expected instances");
}

TEST_F(JsonInstances, RefuseMoreRowsThanAnyReaderTakes) {
  std::string q = "0";
  for (int i = 0; i < 16384; ++i) q += ",0";
  EXPECT_EQ(complaint("{\"M\": [], \"q\": [" + q + "]}"),
            "/q: has 16385 entries, expected at most 16384");
}

TEST_F(JsonInstances, RefuseEmptyArraysAndObjectsBeforeTheyFillTheMemory) {
  std::string arrays = "[]", objects = "{}";
  for (int i = 0; i < 16384; ++i) arrays += ",[]";
  for (int i = 0; i < 100; ++i) objects += ",{}";
  EXPECT_EQ(complaint("{\"M\": [" + arrays + "]}"), "has more than 16384 rows in a matrix");
  EXPECT_EQ(complaint("{\"instances\": [" + objects + "]}"),
            "has more objects than instances could have");
}

TEST_F(JsonInstances, CannotHoldATextThatIsNoUtf8) {
  EXPECT_THROW(write_json(path, {make_instance("\xFF", cases::plain(), {})}), UnwritableOutput);
  EXPECT_TRUE(folder.empty());
}

}  // namespace
}  // namespace lcp
