// The real program against pipes where files belong, names that look like options, and limits.

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using test::Ended;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;
using nlohmann::json;

class Obstacles : public testing::Test {
 protected:
  void SetUp() override { test::write_sweep(folder.path(), 1000, R"({"v_imp_cm_per_s": [15]})"); }

  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  void make_pipe(const fs::path& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); }
  fs::path submitted() {
    EXPECT_EQ(eerie({"submit", "sweep.json"}).code, 0);
    const std::string listed = eerie({"expand", "sweep.json", "--list", "--json"}).out;
    const std::string hash = json::parse(listed).at("list").at(0).at("hash").get<std::string>();
    return folder / "eerie.sqlite.jobs" / hash.substr(0, 16);
  }

  /// A request for a sweep over so many seeds, as another program might leave it.
  void put_request_of_seeds(int count) {
    const fs::path inbox = folder / "eerie.sqlite.inbox";
    fs::create_directories(inbox);
    const json seeds = {{"from", 0}, {"to", count - 1}, {"step", 1}};
    const json sweep = {{"name", "b"}, {"grid", {{"numerics.seed", seeds}}}};
    install_text(inbox / "0-a4a4a4a4.json",
                 json{{"id", "a4a4a4a4"}, {"kind", "submit"}, {"sweep", sweep.dump()}}.dump());
  }

  test::TemporaryFolder folder;
};

TEST_F(Obstacles, APipeInPlaceOfTheLogIsRefused) {
  submitted();
  make_pipe(folder / "eerie.sqlite.log");
  const Ended ended = eerie({"daemon", "--until-idle", "--min-free-mb", "0"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("eerie.sqlite.log is in the way: it is no file"));
}

TEST_F(Obstacles, APipeUnderAnyNameInAJobFolderFailsThatJobWithTheReason) {
  const fs::path job = submitted();
  for (const char* name : {"settling_target.hdf5", "checkpoint.hdf5", "snapshot_0000.hdf5",
                           "before_end.hdf5", "something"}) {
    fs::remove_all(job);
    fs::create_directories(job);
    make_pipe(job / name);
    eerie({"retry", "--all"});
    const Ended ended = eerie({"daemon", "--until-idle", "--min-free-mb", "0"});
    EXPECT_EQ(ended.code, 0) << name;
    EXPECT_THAT(ended.err, HasSubstr(std::string(name) + " is in the way")) << name;
  }
}

TEST_F(Obstacles, ADatabaseWhoseNameLooksLikeAnOptionWorks) {
  const Ended ended = eerie({"run", "sweep.json", "--db=-x.sqlite", "--min-free-mb", "0"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 of 1 jobs done"));
}

TEST_F(Obstacles, AnOptionWithoutAValueBehindItsSignTakesNoOtherWord) {
  const Ended ended = eerie({"status", "--db=", "--json"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--db=: has no value behind its sign"));
}

TEST_F(Obstacles, WholeNumbersAreDecimal) {
  submitted();
  EXPECT_EQ(eerie({"priority", "010", "--all"}).code, 0);
  EXPECT_THAT(eerie({"query", "--of", "jobs", "--json"}).out + eerie({"status", "--json"}).out,
              Not(HasSubstr("\"priority\": 8")));
  for (const char* wrong : {"0x10", " 9", "9 ", "1e3", ""}) {
    const Ended ended = eerie({"query", "--limit", wrong});
    EXPECT_EQ(ended.code, 2) << wrong;
    EXPECT_THAT(ended.err, HasSubstr("--limit")) << wrong;
  }
}

TEST_F(Obstacles, ANumberOfAConditionIsDecimal) {
  submitted();
  for (const char* wrong : {"seed=0x1", "seed=0x1:0x2"})
    EXPECT_EQ(eerie({"query", "--where", wrong}).code, 2) << wrong;
}

TEST_F(Obstacles, AQuietDaemonSaysNothingButComplaints) {
  submitted();
  const Ended ended = eerie({"daemon", "--quiet", "--until-idle", "--min-free-mb", "0"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out + ended.err, "");
  EXPECT_THAT(read_file(folder / "eerie.sqlite.log"), HasSubstr("event=daemon-ends"));
}

TEST_F(Obstacles, ALimitOfFileSizesIsToldLikeAFullDisk) {
  const std::string command = "cd '" + folder.path().string() + "' && ulimit -f 40 && '" +
                              test::program().string() + "' submit sweep.json > said.txt 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3);
  EXPECT_THAT(read_file(folder / "said.txt"), HasSubstr("ulimit -f"));
}

TEST_F(Obstacles, ADaemonThatHangsInARequestWithoutEndEndsWhenTold) {
  submitted();
  put_request_of_seeds(200000);
  Program daemon(folder.path(), {"daemon", "--min-free-mb", "0"});
  test::eventually([&] { return daemon.said().find("event=daemon ") != std::string::npos; });
  daemon.send(SIGTERM);
  EXPECT_THAT(daemon.wait().code, testing::AnyOf(0, 3));
  const Ended doctor = eerie({"doctor"});
  EXPECT_EQ(doctor.code, 0) << doctor.out;
}

TEST_F(Obstacles, ARequestOfMoreJobsThanASweepMayHaveIsSetAside) {
  submitted();
  put_request_of_seeds(1000000);
  const Ended ended = eerie({"daemon", "--until-idle", "--min-free-mb", "0"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("refused"), HasSubstr("more than 200000 values")));
}

}  // namespace
}  // namespace eerie
