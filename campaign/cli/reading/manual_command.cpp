#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/manual/completion.hpp"
#include "campaign/manual/man_page.hpp"
#include "campaign/manual/manual_files.hpp"

namespace eerie::cli {
namespace {

struct ManualArguments {
  std::string command, shell;
  std::filesystem::path folder;
};

Answer write_all(const manual::CommandPage& program, const std::string& version,
                 const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  text::make_given_folder(folder);
  for (const manual::ManualFile& file : manual::manual_files(program, version)) {
    files.push_back(folder / file.path);
    text::make_given_folder(files.back().parent_path());
    install(files.back(), file.text);
  }
  Answer answer;
  answer.data = {{"files", names_of(files)}};
  answer.add_files(files);
  return answer;
}

std::string text_of(const ManualArguments& a, const manual::CommandPage& program,
                    const std::string& version) {
  if (a.shell == "bash") return manual::bash_completion(program);
  if (a.shell == "zsh") return manual::zsh_completion(program);
  if (a.shell == "fish") return manual::fish_completion(program);
  if (a.command.empty()) return manual::program_page(program, version);
  for (const manual::CommandPage& page : program.commands)
    if (page.name == a.command) return manual::command_page(page, version);
  throw InputError(
      fmt::format("there is no page of \"{}\"; `eerie --help` lists the commands", a.command));
}

}  // namespace

Action add_manual(CLI::App& app) {
  auto a = std::make_shared<ManualArguments>();
  app.add_option("COMMAND", a->command, "the command whose page is printed; none: the program's");
  app.add_option("--completion", a->shell, "print what makes this shell complete commands instead")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  app.add_option("-o,--output", a->folder, "write all pages and completions into this folder");
  add_formats(app);
  return [a, &app](Output&) {
    const manual::CommandPage program = manual::described(*app.get_parent());
    const std::string version = job_folder::provenance().version;
    if (!a->folder.empty()) return write_all(program, version, a->folder);
    Answer answer;
    const std::string text = text_of(*a, program, version);
    answer.data = {{"text", text}};
    answer.add_text(text);
    return answer;
  };
}

}  // namespace eerie::cli
