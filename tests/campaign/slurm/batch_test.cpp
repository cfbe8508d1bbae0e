#include "campaign/slurm/batch.hpp"

#include <gmock/gmock.h>

#include "campaign/slurm/commands.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::slurm {
namespace {
using testing::ElementsAre;
using testing::IsEmpty;
namespace fs = std::filesystem;

class ABatch : public testing::Test {
 protected:
  ABatch() {
    batch.folder = batches_folder(folder.path()) / new_batch_id();
    batch.array = {{{1, {folder / "a"}}, {2, {folder / "b"}}}, {{3, {folder / "c"}}}};
  }

  test::TemporaryFolder folder;
  Batch batch;
};

TEST_F(ABatch, IsReadAsItWasInstalled) {
  install_batch(batch, "/opt/eerie");
  auto read = read_batch(batch.folder);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name(), batch.name());
  ASSERT_EQ(read->array.size(), 2u);
  EXPECT_EQ(read->array[0][1].job, 2);
  EXPECT_EQ(read->array[1][0].directory.path, folder / "c");
  EXPECT_EQ(read->slurm_id, std::nullopt);
  EXPECT_EQ(read->submitted, batch.submitted);
  install_slurm_id(batch, {1234, ""});
  EXPECT_EQ(read_batch(batch.folder)->slurm_id, (SlurmJobId{1234, ""}));
  install_slurm_id(batch, {1234, "east"});
  EXPECT_EQ(read_batch(batch.folder)->slurm_id, (SlurmJobId{1234, "east"}));
  EXPECT_THAT(read_released(batch), IsEmpty());
  install_released(batch, {2, 3});
  EXPECT_THAT(read_released(batch), ElementsAre(2, 3));
  remove_batch(batch);
  EXPECT_FALSE(fs::exists(batch.folder));
  EXPECT_FALSE(read_batch(batch.folder));
}

TEST_F(ABatch, WithATornOrForeignManifestIsNone) {
  install_batch(batch, "/opt/eerie");
  const std::string whole = read_file(batch.manifest());
  for (const std::string& text :
       {whole.substr(0, whole.size() / 2), std::string("[]"), std::string("{\"version\": 1}"),
        std::string(R"({"version": 2, "array": []})"),
        std::string(R"({"version": 1, "array": [[{"job": "x"}]]})")}) {
    install_text(batch.manifest(), text);
    EXPECT_FALSE(read_batch(batch.folder)) << text;
  }
}

TEST_F(ABatch, HasAScriptThatRunsTheProgramWhateverItsFolderIsCalled) {
  const fs::path odd = folder / "it's $HOME; `id` \"%a\"\n& co";
  fs::create_directories(odd);
  install_text(odd / "eerie", "#!/bin/sh\nprintf '%s|' \"$@\"\n");
  fs::permissions(odd / "eerie", fs::perms::owner_all);
  install_text(folder / "run.sh", batch_script(odd / "eerie", odd));
  const CommandEnd end =
      ChildCommands().run({"sh", (folder / "run.sh").string()}, std::chrono::seconds(30));
  EXPECT_EQ(end.out, "slurm-task|" + odd.string() + "|") << end.err;
}

TEST(BatchIds, Differ) {
  std::set<std::string> ids;
  for (int k = 0; k < 100; ++k) ids.insert(new_batch_id());
  EXPECT_EQ(ids.size(), 100u);
}

}  // namespace
}  // namespace eerie::slurm
