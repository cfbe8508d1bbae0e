#include "campaign/text/given_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/text/given_folder.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::text {
namespace {
using testing::HasSubstr;
namespace fs = std::filesystem;

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AGivenFile, MayBeAPipe) {
  const test::TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string text = "{\"a\": \"" + std::string(100'000, 'x') + "\"}";
  std::thread writer([&] { std::ofstream(pipe) << text; });
  const nlohmann::json document = load_given_json(pipe);
  writer.join();
  EXPECT_EQ(document.at("a").get<std::string>().size(), 100'000u);
}

TEST(AGivenFile, IsRefusedWhereItIsEndlessOrNotThereOrAFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal([] { read_given("/dev/zero", 1 << 20); }),
              HasSubstr("more than the 1048576"));
  EXPECT_THAT(refusal([&] { read_given(folder / "none", 100); }), HasSubstr("No such file"));
  EXPECT_THAT(refusal([&] { read_given(folder.path(), 100); }), HasSubstr("Is a directory"));
}

TEST(AGivenFile, HasANameForPeople) {
  const test::TemporaryFolder folder;
  install_text(folder / "a.csv", "");
  EXPECT_EQ(given_name("-"), "standard input");
  EXPECT_EQ(given_name("a/b.json"), "a/b.json");
  EXPECT_TRUE(is_named_file(folder / "a.csv"));
  EXPECT_FALSE(is_named_file("-"));
  EXPECT_FALSE(is_named_file("/dev/fd/63"));
}

// A pipe in a folder of requests or jobs would keep a manager waiting for ever.
TEST(AJsonFile, OfAProgramMayNotBeAPipe) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal([&] { load_json(folder / "pipe"); }), HasSubstr("no plain file"));
}

TEST(AGivenFolder, IsMadeWhereTheOneAboveIsThere) {
  const test::TemporaryFolder folder;
  make_given_folder(folder / "new/");
  EXPECT_TRUE(fs::is_directory(folder / "new"));
  make_given_folder(folder / "new");
  EXPECT_THAT(refusal([&] { make_given_folder(folder / "typo/here"); }), HasSubstr("mkdir -p"));
  EXPECT_FALSE(fs::exists(folder / "typo"));
}

TEST(AGivenFolder, IsNeverMadeForAFile) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { require_folder_of(folder / "typo/a.csv"); }), HasSubstr("typo"));
  EXPECT_FALSE(fs::exists(folder / "typo"));
  require_folder_of("a.csv");
  require_folder_of(folder / "a.csv");
}

}  // namespace
}  // namespace eerie::text
