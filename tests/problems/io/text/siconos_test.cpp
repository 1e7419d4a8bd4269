#include "problems/io/text/siconos.h"

#include <gtest/gtest.h>

#include "problems/contact/friction_lcp.h"
#include "problems/io/errors.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"
#include "tests/problems/io/text/siconos_files.h"

namespace lcp {
namespace {

class Siconos : public testing::Test {
 protected:
  Instance read(const std::string& text, const ReadOptions& options = {}) {
    files::put(path, text);
    return read_siconos(path, "x", options);
  }
  std::string complaint(const std::string& text) {
    const std::string message = files::message_of<UnreadableInput>([&] { read(text); });
    return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
  }

  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.dat");
};

TEST_F(Siconos, ReadsADenseLcpColumnByColumn) {
  const Instance instance = read(siconos::dense_lcp);
  EXPECT_EQ(instance.problem.M, (MatrixXd{{1, 3}, {2, 4}}));
  EXPECT_EQ(instance.problem.q, (VectorXd{{-5, 1e-300}}));
  EXPECT_EQ(instance.provenance.at("format"), "Siconos LCP");
  EXPECT_EQ(instance.provenance.at("storage"), "dense, column by column");
  EXPECT_EQ(instance.provenance.at("file"), path);
  Problem plain = instance.problem;
  set_plain_scales(plain);
  EXPECT_EQ(content_hash(plain), instance.sha256);
}

TEST_F(Siconos, ReadsBlocksEachColumnByColumn) {
  // Blocks of 2 x 2, 2 x 1 and 1 x 1; none at the lower left.
  EXPECT_EQ(read(siconos::block_lcp).problem.M, (MatrixXd{{1, 3, 5}, {2, 4, 6}, {0, 0, 7}}));
}

TEST_F(Siconos, ReadsWhatCsparsePrints) {
  const MatrixXd expected{{4, 0.5}, {0, 5}};
  const std::string head = "2\n2\n2\n2\n";
  const std::string title = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) T. Davis\n";
  const std::string columns =
      "2-by-2, nzmax: 9 nnz: 3, 1-norm: 5.5\n    col 0 : locations 0 to 0\n      0 : 4\n"
      "    col 1 : locations 1 to 2\n      0 : 0.5\n      1 : 5\n";
  const std::string q = "-1 -2\n";
  EXPECT_EQ(read(head + "2\n" + title + columns + q).problem.M, expected);
  EXPECT_EQ(read(head + "3\n" + title + columns + q).problem.M, expected.transpose());
  EXPECT_EQ(read(head + "1\n" + title +
                 "triplet: 2-by-2, nzmax: 9 nnz: 4\n 1 1 : 5\n 0 0 : 3\n 0 1 : 0.5\n 0 0 : 1\n" + q)
                .problem.M,
            expected);
}

TEST_F(Siconos, ReadsFrictionContactsInEveryStorage) {
  ContactProblem contacts;
  contacts.contacts.push_back(
      make_contact(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 0.1, {}));
  contacts.W = MatrixXd{{15, -1, -2}, {-1, 14, 1}, {-2, 1, 16}};
  contacts.vbar = VectorXd{{-1, 2, 3}};
  const std::string hash = content_hash(friction_lcp(contacts));
  for (const char* text :
       {siconos::dense_contact, siconos::block_contact, siconos::compressed_contact}) {
    const Instance instance = read(text);
    EXPECT_EQ(instance.sha256, hash) << text;
    EXPECT_EQ(instance.provenance.at("format"), "Siconos friction contact");
    EXPECT_EQ(instance.provenance.at("dimension"), "3");
    EXPECT_EQ(instance.provenance.at("asymmetry of W"), "0");
  }
  EXPECT_EQ(read(siconos::dense_contact, {.directions = 4}).problem.size(), 1 + 4 + 1);
}

TEST_F(Siconos, PutsContactsOfThePlaneIntoSpace) {
  const Instance instance = read("2 1 0 2 2 2 2  4 0.5 0.5 5  -1 2  0.3");
  const FrictionBlocks& blocks = *instance.problem.friction;
  EXPECT_EQ(blocks.W, (MatrixXd{{4, 0.5, 0}, {0.5, 5, 0}, {0, 0, 0}}));
  EXPECT_EQ(blocks.vbar, (VectorXd{{-1, 2, 0}}));
  // a, b along +t and -t, lambda: (25) by hand.
  EXPECT_EQ(instance.problem.M,
            (MatrixXd{{4, 0.5, -0.5, 0}, {0.5, 5, -5, 1}, {-0.5, -5, 5, 1}, {0.3, -1, -1, 0}}));
  EXPECT_EQ(instance.problem.q, (VectorXd{{-1, 2, -2, 0}}));
}

TEST_F(Siconos, TellsTwoBlocksFromOneCompressedContactInThePlane) {
  // Both begin with 2 1 2 2 2.
  const Instance blocks = read("2 1 2 2 2  2 2  1 2  1 2  3 2  0 1 2  0 1  0 7  1 8  -1 -2");
  EXPECT_FALSE(blocks.problem.friction);
  EXPECT_EQ(blocks.problem.M, (MatrixXd{{7, 0}, {0, 8}}));
  const Instance contact = read(
      "2 1 2 2 2 2\nCSparse Version\n2-by-2, nzmax: 2 nnz: 2, 1-norm: 8\ncol 0 : locations 0 to 0\n"
      "0 : 7\ncol 1 : locations 1 to 1\n1 : 8\n-1 -2 0.5");
  ASSERT_TRUE(contact.problem.friction);
  EXPECT_EQ(contact.problem.friction->W, (MatrixXd{{7, 0, 0}, {0, 8, 0}, {0, 0, 0}}));
}

TEST_F(Siconos, ToleratesAMeasuredAsymmetryAndKeepsIt) {
  const Instance instance =
      read("3 1 0 3 3 3 3  1 0 0  0 1 1e-5  0 0 1  -1 2 3  0.5\n1\nguess that is not read 7");
  EXPECT_EQ(instance.problem.friction->W(2, 1), 1e-5);
  EXPECT_EQ(instance.problem.friction->W(1, 2), 0);
  EXPECT_EQ(instance.provenance.at("asymmetry of W"), "1e-05");
  EXPECT_EQ(complaint("3 1 0 3 3 3 3  1 0 0  0 1 0.5  0 0 1  -1 2 3  0.5"),
            "contact problem: W(2, 1) is 0.5 but W(1, 2) is 0, expected a symmetric W");
}

TEST_F(Siconos, TakesATextBehindTheNumbersButNoFurtherNumber) {
  EXPECT_EQ(read("1 0 1 1 1 1 2 -3\n\nRemark 4.1.14 of a book\n").problem.size(), 1);
  EXPECT_EQ(complaint("1 0 1 1 1 1 2 -3\n4"), "line 2: '4', expected the end of the numbers");
}

TEST_F(Siconos, SaysWhatItExpectedWhere) {
  EXPECT_EQ(complaint("3\n1\n0\n4\n3\n"),
            "line 1: '3', expected the head of an LCP (n, storage 0 ... 2, n, n) or of a "
            "friction-contact problem (dimension d = 2 or 3, contacts Nc, storage 0 ... 2, d Nc, "
            "d Nc)");
  EXPECT_EQ(complaint("2\n0\n2\n2\n2 2\n1 2 x 4\n-1 -1\n"),
            "line 6: 'x', expected M: a finite number");
  EXPECT_EQ(complaint("1 0 1 1 1 1\nnan -3"), "line 2: 'nan', expected M: a finite number");
  EXPECT_EQ(complaint("1 0 1 1 1 1 1e999 -3"), "line 1: '1e999', expected M: a finite number");
  EXPECT_EQ(complaint("1 0 1 1 1 1 3\n"),
            "line 2: the end of the file, expected q: a finite number");
  EXPECT_EQ(complaint("16000 0 16000 16000 16000 16000 1 2 3"),
            "line 1: 6 bytes left, expected 256000000 numbers of M");
  EXPECT_EQ(complaint("17000 0 17000 17000"),
            "line 1: '17000', expected n: a whole number in 1 ... 16384");
  EXPECT_EQ(complaint("2 1 2 2  1 1 1  2 2  2 1  0 1  3  0  1 2 3 4  5 6"),
            "line 1: '3', expected block column of a block: a whole number in 0 ... 0");
  EXPECT_EQ(complaint("2 1 2 2  1 1 1  3 2  2 1  0 1  0  0  1 2 3 4  5 6"),
            "line 1: '3', expected end of a block row: a whole number in 2 ... 2");
  EXPECT_EQ(complaint("3 5000 1 15000 15000 0"),
            "5000 contacts with 8 directions make an LCP of 50000 rows, expected at most 16384");
}

}  // namespace
}  // namespace lcp
