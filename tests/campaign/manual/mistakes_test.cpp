#include "campaign/manual/mistakes.hpp"

#include <gmock/gmock.h>

#include "campaign/manual/help_text.hpp"
#include "solver/base/error.hpp"

namespace eerie::manual {
namespace {
using testing::HasSubstr;
using testing::StartsWith;

class Mistakes : public testing::Test {
 protected:
  Mistakes() {
    app_.require_subcommand(1);
    CLI::App* run = app_.add_subcommand("run", "Run a sweep");
    run->add_option("--set", words_)->allow_extra_args(false);
    run->add_option("-o,--output", word_);
    app_.add_subcommand("query", "List results")->add_option("--v", word_, "impact speed");
    app_.add_subcommand("map", "Draw a map");
    app_.add_subcommand("secret", "not for people")->group("");
  }
  std::string said_of(std::vector<std::string> arguments) {
    std::ranges::reverse(arguments);  // as CLI11 takes them
    try {
      app_.parse(arguments);
    } catch (const CLI::ParseError&) {
    }
    return unknown_options(app_, {"impact.v_imp_cm_per_s", "numerics.seed"});
  }

  CLI::App app_{"a program", "eerie"};
  std::vector<std::string> words_;
  std::string word_;
};

TEST_F(Mistakes, InCommandsAreAnsweredByMeaningAndSpelling) {
  EXPECT_EQ(unknown_command(app_, "run"), "");
  EXPECT_EQ(unknown_command(app_, "secret"), "");
  EXPECT_THAT(unknown_command(app_, "plot"), HasSubstr("\"plot\"; did you mean map?"));
  EXPECT_THAT(unknown_command(app_, "quary"), HasSubstr("did you mean query?"));
  EXPECT_EQ(unknown_command(app_, "fly"),
            "there is no command \"fly\". The commands are run, query, map");
}

TEST_F(Mistakes, InOptionsNameTheCommandAndTheOptionThatIsMeant) {
  EXPECT_EQ(said_of({"run", "--out=x"}),
            "`eerie run` has no option --out; did you mean --output?\n`eerie run --help` lists its "
            "options");
  EXPECT_THAT(said_of({"run", "--velocity", "3"}),
              HasSubstr("did you mean --set impact.v_imp_cm_per_s=VALUE?"));
  EXPECT_THAT(said_of({"query", "--banana"}), StartsWith("`eerie query` has no option --banana\n"));
  EXPECT_EQ(said_of({"run", "--output", "x"}), "");
}

TEST_F(Mistakes, AreNoneInHelpOfACommand) {
  EXPECT_THAT(help_text(app_, {"run"}), HasSubstr("Usage: eerie run [OPTIONS]"));
  EXPECT_THAT(help_text(app_, {}), HasSubstr("Usage: eerie"));
  EXPECT_THAT([&] { help_text(app_, {"plot"}); },
              testing::ThrowsMessage<InputError>(HasSubstr("did you mean map?")));
}

}  // namespace
}  // namespace eerie::manual
