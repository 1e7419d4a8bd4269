#include "problems/io/child_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "problems/io/errors.h"
#include "problems/io/file_descriptor.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

constexpr unsigned plenty = 60;  // s

std::string death_of(unsigned seconds, const std::function<std::string()>& work) {
  return files::message_of<UnreadableInput>([&] { try_in_child("reading x", seconds, work); });
}

TEST(TryInChild, ReturnsWhatTheWorkReturned) {
  const std::string long_text(1 << 20, 'x');  // a pipe holds 64 KiB
  EXPECT_EQ(try_in_child("reading x", plenty, [&] { return long_text; }), long_text);
}

TEST(TryInChild, LeavesThisProcessAsItWas) {
  int touched = 0;
  try_in_child("reading x", plenty, [&] {
    touched = 1;
    return std::string();
  });
  EXPECT_EQ(touched, 0);
}

TEST(TryInChild, PassesOnTheMessageOfAnException) {
  EXPECT_EQ(
      death_of(plenty, []() -> std::string { throw std::runtime_error("x: 3 rows, expected 4"); }),
      "x: 3 rows, expected 4");
}

TEST(TryInChild, NamesTheSignalOfACrash) {
  EXPECT_EQ(death_of(plenty, []() -> std::string { std::abort(); }),
            "reading x: crashed with signal 6 (Aborted)");
}

TEST(TryInChild, NamesTheStatusOfAnEarlyExit) {
  EXPECT_EQ(death_of(plenty, []() -> std::string { _exit(7); }), "reading x: exited with status 7");
}

TEST(TryInChild, StopsWorkThatHangs) {
  EXPECT_EQ(death_of(1, [] { return std::string(static_cast<std::size_t>(pause()), ' '); }),
            "reading x: still not done after 1 s");
}

/// What a child says on its channel; its process is killed and reaped when that is closed.
std::string said_by(ChildStreams streams, const std::function<std::string()>& work) {
  Pipe pipe = make_pipe();
  streams.channel = pipe.writing.get();
  const ChildProcess child(streams, [&](int channel) { write_all(channel, work()); });
  pipe.writing.reset();
  return read_all(pipe.reading.get());
}

TEST(ChildProcess, HasNoFileOpenButItsStreamsUnlessItKeepsThem) {
  const files::TemporaryFolder folder;
  const FileDescriptor low(open(folder.file("x").c_str(), O_WRONLY | O_CREAT, 0666));
  const FileDescriptor file(fcntl(low.get(), F_DUPFD, 50));  // a number that no stream has
  const auto work = [&] { return std::string(write_all(file.get(), "kept") ? "open" : "closed"); };
  EXPECT_EQ(said_by({}, work), "closed");
  EXPECT_EQ(said_by({.keeps_files = true}, work), "open");
}

TEST(ChildProcess, LeadsAGroupOfItsOwnAndReadsNothing) {
  EXPECT_EQ(said_by({},
                    [] {
                      char byte;
                      return std::string(getpgrp() == getpid() ? "own" : "other") +
                             std::to_string(read(STDIN_FILENO, &byte, 1));
                    }),
            "own0");
}

TEST(ChildProcess, IsKilledWithWhatItStartedWhenItsObjectGoes) {
  Pipe pipe = make_pipe();
  {
    const ChildProcess child({.channel = pipe.writing.get()}, [](int channel) {
      if (fork() >= 0) write_all(channel, "x");  // by both
      pause();
    });
    pipe.writing.reset();
    char bytes[2];
    for (char& byte : bytes) ASSERT_EQ(read(pipe.reading.get(), &byte, 1), 1);
  }
  EXPECT_EQ(read_all(pipe.reading.get()), "") << "this ends when the last writer has ended";
}

TEST(OutputOf, TellsWhatAProgramPrintedWhereItRanAndHowItEnded) {
  const files::TemporaryFolder folder;
  const ProgramOutput output = output_of(
      "sh", {"-c", "pwd; echo; echo 'bad day' >&2; echo more >&2; exit 3"}, folder.path());
  EXPECT_EQ(output.out, std::filesystem::canonical(folder.path()).string() + "\n\n");
  EXPECT_EQ(output.complaint, "bad day");
  EXPECT_EQ(how_it_ended(output.status), "exited with status 3");
  EXPECT_EQ(output_of("true", {}, folder.path()).status, 0);
}

TEST(OutputOf, SaysThatAProgramIsNotInstalled) {
  try {
    output_of("no-such-program", {}, ".");
    ADD_FAILURE();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_NE(std::string(error.what()).find("no-such-program"), std::string::npos);
  }
}

}  // namespace
}  // namespace lcp
