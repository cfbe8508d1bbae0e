#include "campaign/cli/output/output.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>

#include "campaign/cli/output/progress_line.hpp"
#include "campaign/text/layout.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::cli {
namespace {
using testing::HasSubstr;

Answer answer() {
  Answer a;
  a.data = {{"sweep", "first"}, {"jobs", 2}};
  a.say("{}: {} jobs\n", "first", 2);
  a.add(Table{{both("q", "q"), both("class", "class")}, {{1.0, "erosion"}}}, "*  a mark\n");
  return a;
}

TEST(Rendered, IsOfOneAnswerInEveryFormat) {
  EXPECT_EQ(rendered(answer(), Format::people, 0),
            "first: 2 jobs\nq  class\n1  erosion\n\n*  a mark\n");
  EXPECT_EQ(rendered(answer(), Format::json, 0), "{\n \"jobs\": 2,\n \"sweep\": \"first\"\n}\n");
  EXPECT_EQ(rendered(answer(), Format::csv, 0), "q,class\n1.0,erosion\n");
  EXPECT_EQ(rendered(answer(), Format::nothing, 0), "");
}

TEST(Rendered, JsonIsUtf8WhateverAPathIsCalled) {
  Answer a;
  a.data = {{"file", "a\xff.csv"}};
  EXPECT_EQ(rendered(a, Format::json, 0), "{\n \"file\": \"a\\\\xff.csv\"\n}\n");
}

TEST(Lines, MakeTheirArgumentsPlainAndKeepTheirOwnEnds) {
  EXPECT_EQ(line("{}: {}\n", std::string("a\x1b[31m\nb"), 3), "a\\x1b[31m\\nb: 3\n");
  EXPECT_EQ(line("{:>6}|\n", std::filesystem::path("\x07x")), " \\x07x|\n");
  EXPECT_EQ(line("{}\n", static_cast<const char*>("\x9b")), "\xef\xbf\xbd\n");
}

/// A descriptor that is closed with it.
struct Descriptor {
  explicit Descriptor(int number_) : number(number_) {}
  ~Descriptor() { ::close(number); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number;
};

TEST(Output, SaysAtItsEndWhatCouldNotBeWritten) {
  const Descriptor full(::open("/dev/full", O_WRONLY));
  Output out(full.number);
  out.print(answer());
  EXPECT_TRUE(out.is_over());
  try {
    out.finish();
    ADD_FAILURE() << "nothing was said";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot write the output: No space left"));
  }
}

TEST(Output, TakesAReaderWhoHasGoneForNoError) {
  std::signal(SIGPIPE, SIG_IGN);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const Descriptor writing(ends[1]);
  Output out(writing.number);
  out.print(answer());
  EXPECT_TRUE(out.is_over());
  EXPECT_NO_THROW(out.finish());
}

TEST(Output, WritesAllOfWhatItIsGiven) {
  test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "out";
  const std::string text(3'000'000, 'x');
  {
    const Descriptor writing(::open(file.c_str(), O_WRONLY | O_CREAT, 0644));
    Output out(writing.number);
    out.write(text);
    EXPECT_NO_THROW(out.finish());
  }
  EXPECT_EQ(read_file(file), text);
}

TEST(Output, SaysNothingToPeopleInOtherFormats) {
  test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "out";
  {
    const Descriptor writing(::open(file.c_str(), O_WRONLY | O_CREAT, 0644));
    Output out(writing.number, Format::json);
    out.say("{} jobs\n", 3);
    out.format = Format::nothing;
    out.print(answer());
  }
  EXPECT_EQ(read_file(file), "");
}

TEST(ProgressText, ShowsJobsSpeedAndTimeLeft) {
  manager::CampaignView view;
  view.total = 15, view.done = 3, view.failed = 1, view.running = 2;
  view.particle_steps_per_s = 1.9e6;
  view.eta_s = 200;
  EXPECT_EQ(progress_text(view, false),
            "3/15 done, 1 failed, 2 running | 1.9 M particle-steps/s | ETA 3 min 20 s");
  EXPECT_THAT(progress_text(view, true), testing::StartsWith("[######------------------] 3/15"));
}

TEST(ProgressText, FitsAnyTerminalAndLeavesOutTheBarFirst) {
  manager::CampaignView view;
  view.total = 15000, view.done = 3000, view.failed = 12, view.running = 24;
  view.particle_steps_per_s = 1.9e6, view.eta_s = 20000;
  for (std::size_t width = 1; width < 130; ++width)
    EXPECT_LE(text::width_of(progress_fitting(view, width, true)), width);
  EXPECT_EQ(progress_fitting(view, 0, true), progress_text(view, true));
  EXPECT_EQ(progress_fitting(view, 95, true), progress_text(view, false));
  EXPECT_EQ(progress_fitting(view, 60, true), "3000/15000 done, 12 failed, 24 running | ETA 5.6 h");
}

}  // namespace
}  // namespace eerie::cli
