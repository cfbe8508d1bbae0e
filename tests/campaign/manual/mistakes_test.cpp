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
    run->add_option("SWEEP", word_, "sweep file")->required();
    run->add_option("--workers", number_, "processes")->check(CLI::Range(1, 64));
    run->add_option("--least", real_)->check(CLI::Range(0.5, 0.999));
    run->add_option("--scheduler", word_)->check(CLI::IsMember({"local", "slurm"}));
    run->add_option("--finest", word_)->needs(run->get_option("--least"));
    run->add_option("--coarse", word_)->excludes(run->get_option("--least"));
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

  std::string complaint(std::vector<std::string> arguments) {
    std::ranges::reverse(arguments);
    try {
      app_.parse(arguments);
    } catch (const CLI::ParseError& error) {
      return wrong_use(app_, error);
    }
    return "";
  }

  CLI::App app_{"a program", "eerie"};
  int number_ = 0;
  double real_ = 0;
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

TEST_F(Mistakes, InValuesNameTheOptionTheValueAndWhatIsAllowed) {
  const auto begins = [](const std::string& text) {
    return StartsWith(text + "\n`eerie run --help` lists its options");
  };
  EXPECT_EQ(complaint({}), "`eerie` needs a command\n`eerie --help` lists its commands");
  EXPECT_THAT(complaint({"run"}), begins("`eerie run` needs SWEEP: sweep file"));
  EXPECT_THAT(complaint({"run", "a", "--workers", "0"}), begins("--workers = 0: must be 1 to 64"));
  EXPECT_THAT(complaint({"run", "a", "--workers", "two"}),
              begins("--workers = two: must be 1 to 64"));
  EXPECT_THAT(complaint({"run", "a", "--least", "2"}), begins("--least = 2: must be 0.5 to 0.999"));
  EXPECT_THAT(complaint({"run", "a", "--scheduler", "pbs"}),
              begins("--scheduler = pbs: must be one of local, slurm"));
  EXPECT_THAT(complaint({"run", "a", "--workers"}), begins("--workers needs a value: processes"));
  EXPECT_THAT(complaint({"run", "a", "b", "c"}),
              begins("`eerie run` does not know what to do with b c; it takes no such word"));
  EXPECT_THAT(complaint({"run", "a", "--finest", "x"}),
              begins("--finest goes with --least; give both, or neither"));
  EXPECT_THAT(complaint({"run", "a", "--coarse", "x", "--least", "0.6"}),
              begins("--least and --coarse exclude each other; give one"));
}

TEST_F(Mistakes, AreNoneInHelpOfACommand) {
  EXPECT_THAT(help_text(app_, {"run"}), HasSubstr("Usage: eerie run [OPTIONS]"));
  EXPECT_THAT(help_text(app_, {}), HasSubstr("Usage: eerie"));
  EXPECT_THAT([&] { help_text(app_, {"plot"}); },
              testing::ThrowsMessage<InputError>(HasSubstr("did you mean map?")));
}

}  // namespace
}  // namespace eerie::manual
