#include <gmock/gmock.h>

#include "campaign/manual/command_table.hpp"
#include "campaign/manual/completion.hpp"
#include "campaign/manual/man_page.hpp"
#include "campaign/manual/manual_files.hpp"

namespace eerie::manual {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A program with all that a command line can have.
class Manual : public testing::Test {
 protected:
  Manual() {
    app_.add_flag("--version");
    CLI::App* run = app_.add_subcommand("run", "Run what's there: [all] of it");
    run->add_option("SWEEP", sweep_, "sweep file")->required();
    run->add_option("--of", word_, "which")->check(CLI::IsMember({"results", "maps"}));
    run->add_option("-n,--number", number_, "how many")
        ->check(CLI::Range(1, 7))
        ->capture_default_str();
    run->add_option("--set", list_, ".dots and \\backslashes; it's 'quoted'");
    run->footer("Examples:\n  eerie run a.json\n  eerie run b.json --set x=1");
    app_.add_subcommand("secret", "not for people")->group("");
    CLI::App* outer = app_.add_subcommand("outer", "Holds a command");
    outer->add_subcommand("inner", "Is held")->add_flag("--deep");
  }
  CommandPage page(const std::string& name) const {
    for (const CommandPage& command : described(app_).commands)
      if (command.name == name) return command;
    return {};
  }

  CLI::App app_{"a program", "eerie"};
  std::string sweep_, word_;
  std::vector<std::string> list_;
  int number_ = 3;
};

TEST_F(Manual, KnowsOptionsAsTheCommandLineDoes) {
  const std::vector<CommandOption> options = page("run").options;
  ASSERT_EQ(options.size(), 5u);  // --help is one
  EXPECT_TRUE(options[1].is_positional());
  EXPECT_TRUE(options[1].required);
  EXPECT_TRUE(options[1].may_be_file());
  EXPECT_THAT(options[2].choices, ElementsAre("results", "maps"));
  EXPECT_FALSE(options[2].may_be_file());
  EXPECT_THAT(options[3].names, ElementsAre("-n", "--number"));
  EXPECT_EQ(options[3].limits, "1 to 7");
  EXPECT_EQ(options[3].default_value, "3");
  EXPECT_EQ(options[3].value, "INT");
  EXPECT_TRUE(options[4].repeats);
  EXPECT_EQ(options[0].value, "");
}

TEST_F(Manual, LeavesOutWhatIsHidden) {
  const CommandPage program = described(app_);
  EXPECT_EQ(program.commands.size(), 2u);
  for (const ManualFile& file : manual_files(program, "1.0")) {
    EXPECT_THAT(file.path.string(), Not(HasSubstr("secret")));
    EXPECT_THAT(file.text, Not(HasSubstr("secret"))) << file.path;
  }
}

TEST_F(Manual, NoWordOfADescriptionSteersRoff) {
  const std::string text = command_page(page("run"), "1.0");
  EXPECT_THAT(text, HasSubstr("\n\\&.dots and \\ebackslashes; it's 'quoted'\n"));
  EXPECT_THAT(text, HasSubstr("\\fB\\-n\\fR, \\fB\\-\\-number\\fR \\fIINT\\fR\n"
                              "how many; from 1 to 7 (default: 3)\n"));
  EXPECT_THAT(text, HasSubstr("which; one of results, maps\n"));
  EXPECT_THAT(text, HasSubstr("\\fBeerie run\\fR [\\fIOPTIONS\\fR] \\fISWEEP\\fR\n"));
  EXPECT_THAT(text, HasSubstr(".EX\neerie run a.json\neerie run b.json \\-\\-set x=1\n.EE\n"));
}

TEST_F(Manual, ACommandWithinACommandIsInThePageOfThat) {
  EXPECT_THAT(command_page(page("outer"), "1.0"), HasSubstr("eerie outer inner"));
  EXPECT_THAT(command_page(page("outer"), "1.0"), HasSubstr("\\-\\-deep"));
}

TEST_F(Manual, NoWordOfADescriptionEndsAQuoteOfAShell) {
  EXPECT_THAT(zsh_completion(described(app_)), HasSubstr("it'\\''s '\\''quoted'\\''"));
  EXPECT_THAT(zsh_completion(described(app_)), HasSubstr("'run:Run what'\\''s there\\: \\[all\\]"));
  EXPECT_THAT(fish_completion(described(app_)), HasSubstr("\\\\backslashes; it\\'s \\'quoted\\'"));
}

}  // namespace
}  // namespace eerie::manual
