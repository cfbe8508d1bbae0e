#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/sweeps/first_files.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

Answer init(const fs::path& folder) {
  const sweeps::FirstFiles first = sweeps::first_files(folder);
  for (const auto& [name, content] : first.files)
    if (std::error_code ignored; fs::exists(fs::symlink_status(folder / name, ignored)))
      throw InputError(
          fmt::format("{}: is there already, and is not overwritten; give another folder, such as "
                      "`eerie init my-impacts`",
                      (folder / name).string()));
  text::make_given_folder(folder);
  Answer answer;
  std::vector<fs::path> written;
  for (const auto& [name, content] : first.files) {
    written.push_back(folder / name);
    install(written.back(), content);
  }
  answer.data = {{"files", names_of(written)}, {"next", Value::array()}};
  answer.add_files(written);
  for (const auto& [command, meaning] : first.next) {
    answer.data["next"].push_back(command);
    answer.say("\n{}:\n    {}\n", meaning, command);
  }
  return answer;
}

}  // namespace

Action add_init(CLI::App& app) {
  auto folder = std::make_shared<fs::path>(".");
  app.add_option("DIR", *folder, "folder, which is made where it is missing (default: this one)");
  add_formats(app);
  return [folder](Output&) { return init(*folder); };
}

}  // namespace eerie::cli
