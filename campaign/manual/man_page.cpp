#include "campaign/manual/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace eerie::manual {
namespace {

/// Text as it is: no letter steers roff, and hyphens can be copied.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  if (out.starts_with('.') || out.starts_with('\'')) out.insert(0, "\\&");
  return out;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string head(const std::string& name, const std::string& meaning, const std::string& version) {
  return fmt::format(".TH {} 1 \"\" \"eerie {}\" \"eerie manual\"\n.SH NAME\n{} \\- {}\n",
                     upper(plain(name)), version, plain(name), plain(meaning));
}

/// \fB\-\-db\fR \fITEXT\fR
std::string told(const CommandOption& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += fmt::format("{}\\f{}{}\\fR", out.empty() ? "" : ", ", option.is_positional() ? 'I' : 'B',
                       plain(name));
  if (!option.value.empty() && !option.is_positional())
    out += fmt::format(" \\fI{}\\fR", plain(option.value));
  return out;
}

std::string meaning_of(const CommandOption& option) {
  std::string out = plain(option.meaning.empty() ? "see above" : option.meaning);
  if (!option.choices.empty())
    out += plain(fmt::format("; one of {}", fmt::join(option.choices, ", ")));
  if (!option.limits.empty()) out += plain(fmt::format("; from {}", option.limits));
  if (!option.default_value.empty())
    out += plain(fmt::format(" (default: {})", option.default_value));
  if (option.required) out += "; required";
  return out;
}

std::string options_of(const CommandPage& page) {
  std::string out;
  for (const CommandOption& option : page.options)
    out += fmt::format(".TP\n{}\n{}\n", told(option), meaning_of(option));
  return out;
}

/// Arguments by their place, after the options.
std::string synopsis(const std::string& name, const CommandPage& page) {
  std::string out = fmt::format("\\fB{}\\fR [\\fIOPTIONS\\fR]", plain(name));
  for (const CommandOption& option : page.options)
    if (option.is_positional()) {
      const std::string word =
          fmt::format("\\fI{}\\fR{}", plain(option.names.front()), option.repeats ? "..." : "");
      out += option.required ? " " + word : " [" + word + "]";
    }
  if (!page.commands.empty()) out += " \\fICOMMAND\\fR";
  return out + "\n";
}

/// The lines below "Examples:" as they are.
std::string examples_of(const CommandPage& page) {
  const std::string mark = "Examples:\n";
  if (!page.footer.starts_with(mark)) return "";
  std::string out = ".SH EXAMPLES\n.EX\n";
  std::istringstream lines(page.footer.substr(mark.size()));
  for (std::string line; std::getline(lines, line);)
    out += plain(line.substr(std::min(line.find_first_not_of(' '), line.size()))) + "\n";
  return out + ".EE\n";
}

/// A command within a command, in the page of that.
std::string inner(const std::string& outer, const CommandPage& page) {
  const std::string name = outer + " " + page.name;
  return fmt::format(".SS {}\n{}\n.PP\n{}{}", plain(name), plain(page.meaning),
                     synopsis("eerie " + name, page), options_of(page));
}

constexpr const char* exit_status =
    ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\nsome job failed\n.TP\n2\nbad input\n.TP\n3\n"
    "environment: disk, memory, a missing program\n.TP\n130\nstopped by Ctrl\\-C, with "
    "checkpoints\n";

}  // namespace

std::string program_page(const CommandPage& program, const std::string& version) {
  std::string out = head(program.name, "EER Impact Explorer", version);
  out += ".SH SYNOPSIS\n" + synopsis(program.name, program);
  out += ".SH DESCRIPTION\n" + plain(program.meaning) + "\n.SH COMMANDS\n";
  for (const CommandPage& command : program.commands)
    out += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBeerie\\-{}\\fR(1)\n", plain(command.name),
                       plain(command.meaning), plain(command.name));
  out += ".SH OPTIONS\n" + options_of(program) + exit_status;
  out +=
      ".SH FILES\n.TP\n\\fIeerie.sqlite\\fR\nthe database, unless \\-\\-db says otherwise\n"
      ".TP\n\\fIeerie.sqlite.jobs\\fR\nthe job directories beside it\n";
  return out;
}

std::string command_page(const CommandPage& command, const std::string& version) {
  std::string out = head("eerie-" + command.name, command.meaning, version);
  out += ".SH SYNOPSIS\n" + synopsis("eerie " + command.name, command);
  out += ".SH DESCRIPTION\n" + plain(command.meaning) + ".\n";
  if (!command.commands.empty()) out += ".SH COMMANDS\n";
  for (const CommandPage& page : command.commands) out += inner(command.name, page);
  out += ".SH OPTIONS\n" + options_of(command) + examples_of(command) + exit_status;
  return out + ".SH SEE ALSO\n\\fBeerie\\fR(1)\n";
}

}  // namespace eerie::manual
