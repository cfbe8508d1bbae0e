#include "campaign/cli/cli.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/manager/waiting/patience.hpp"
#include "campaign/manual/mistakes.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "db/store/migrations.hpp"
#include "solver/base/error.hpp"
#include "solver/base/simd/pack.hpp"

namespace eerie::cli {
namespace {

struct Command {
  const char* name;
  const char* description;
  const char* examples;  ///< nullptr: hidden from --help
  AddCommand* add;
};

constexpr Command commands[] = {
    {"init", "Write a sweep and a scene to begin with, and say what to type next",
     "  eerie init\n"
     "  eerie init my-impacts",
     add_init},
    {"run", "Run every job of a sweep that is not done yet",
     "  eerie run sweeps/first-light.json\n"
     "  eerie run sweeps/table2-fig2b.json --db fig2b.sqlite --workers 8\n"
     "  eerie run sweeps/first-light.json --set numerics.particles_per_target=5000 "
     "--threads-per-job 2\n"
     "  eerie run sweeps/table2-fig2b.json --fidelity survey\n"
     "  eerie run sweeps/table2-fig2b.json --fidelity auto --confidence 0.9 --budget 2",
     add_run},
    {"expand", "Say what a sweep would run: jobs, new jobs, core-hours",
     "  eerie expand sweeps/table2-fig2a.json\n"
     "  eerie expand sweeps/table2-fig2a.json --list --json",
     add_expand},
    {"solve", "Run one impact without a database",
     "  eerie solve scene.json --out impact\n"
     "  eerie solve scene.json --out impact --set impact.theta_imp_deg=20 --max-steps 1000",
     add_solve},
    {"analyse",
     "Find remnants, shapes, spins and outcome class of a snapshot, or of a database again",
     "  eerie analyse impact/snapshot_0000.hdf5\n"
     "  eerie analyse impact/snapshot_0000.hdf5 --json\n"
     "  eerie analyse --db eerie.sqlite",
     add_analyse},
    {"daemon", "Work on whatever is submitted to a database, until told to stop",
     "  eerie daemon --db campaign.sqlite\n"
     "  eerie daemon --db campaign.sqlite --workers 4 --threads-per-job 2\n"
     "  eerie daemon --db campaign.sqlite --scheduler slurm --profile cluster.json --jobs-dir "
     "/scratch/me/jobs",
     add_daemon},
    {"submit", "Add a sweep to a database, for the daemon or a later run",
     "  eerie submit sweeps/table2-fig2b.json --db campaign.sqlite\n"
     "  eerie submit urgent.json --priority 10 --wall-limit 2h",
     add_submit},
    {"pause", "Start no more of these jobs; running ones stop with a checkpoint",
     "  eerie pause --sweep table2-fig2b\n"
     "  eerie pause --v 30:40 --theta 5",
     add_pause},
    {"resume", "Let paused jobs go on", "  eerie resume --sweep table2-fig2b", add_resume},
    {"cancel", "Give up jobs that have no result", "  eerie cancel 3f9a20c1", add_cancel},
    {"retry", "Try failed and cancelled jobs again, or rerun stale results",
     "  eerie retry --all\n"
     "  eerie retry --stale --sweep table2-fig2b",
     add_retry},
    {"priority", "Let jobs come earlier or later", "  eerie priority 10 --v 20 --theta 15",
     add_priority},
    {"wall-limit", "Limit the wall time of jobs", "  eerie wall-limit 2h --sweep table2-fig2b",
     add_wall_limit},
    {"extend", "Let finished impacts go on to a later end, from where they were",
     "  eerie extend 3f9a20c1 --until 60000\n"
     "  eerie extend --sweep table2-fig2b --v 20 --theta 15 --until 2e5",
     add_extend},
    {"status", "Count the jobs of each sweep, say what is left, group the failures",
     "  eerie status\n"
     "  eerie status --watch\n"
     "  eerie status --db fig2b.sqlite --json",
     add_status},
    {"serve", "Show a database in the browser, live or finished",
     "  eerie serve --db fig2b.sqlite --open\n"
     "  eerie serve --db campaign.sqlite --port 9000 --read-only",
     add_serve},
    {"show", "Show a job: its scene, results, attempts and files; or pictures of its particles",
     "  eerie show 3f9a20c1\n"
     "  eerie show 3f9a20c1 --json\n"
     "  eerie show 3f9a20c1 --panels 0,2500,7500,20000,50000 -o panels.pdf\n"
     "  eerie show impact --colour depth -o panels.png --movie film.mp4",
     add_show},
    {"lightcurve", "Say how the brightness of a remnant changes while it spins",
     "  eerie lightcurve 3f9a20c1\n"
     "  eerie lightcurve impact/final.hdf5 --remnant 2 --json\n"
     "  eerie lightcurve 3f9a20c1 --aspect 70 -o lightcurve.svg",
     add_lightcurve},
    {"remnant", "Keep a remnant as a body for another impact",
     "  eerie remnant 3f9a20c1 -o egg.hdf5\n"
     "  eerie remnant impact --remnant 2 -o shard.hdf5 --json",
     add_remnant},
    {"log", "Print the log of a job", "  eerie log 3f9a20c1\n  eerie log 3f9a20c1 -f", add_log},
    {"doctor", "Look for damage: database, job directories, disk, versions",
     "  eerie doctor\n"
     "  eerie doctor --fix",
     add_doctor},
    {"merge", "Put several databases into one, with nothing double",
     "  eerie merge mine.sqlite theirs.sqlite\n"
     "  eerie merge node1.sqlite node2.sqlite -o all.sqlite\n"
     "  eerie merge node1.sqlite /mnt/stick/node2.sqlite -o all.sqlite --copy",
     add_merge},
    {"query", "List results, remnants or points of the map",
     "  eerie query --eer\n"
     "  eerie query --phi-d 40 --v 18:22 --theta 15 --format csv\n"
     "  eerie query --class hit-and-run --json\n"
     "  eerie query --of remnants --where b_over_a=0:0.3 --sort=-mass_kg --limit 10\n"
     "  eerie query --of maps --columns v_imp_cm_per_s,theta_imp_deg,p_eer -o map.csv",
     add_query},
    {"compare", "Say where two databases, or two settings, differ beyond the scatter of seeds",
     "  eerie compare mine.sqlite theirs.sqlite\n"
     "  eerie compare fig2b.sqlite --of survey --with standard\n"
     "  eerie compare mine.sqlite theirs.sqlite --of fine --with 3 --format csv",
     add_compare},
    {"catalogue", "Exchange impacts and outcomes with catalogues of collisions",
     "  eerie catalogue export --db fig2b.sqlite --fidelity survey -o fig2b.csv\n"
     "  eerie catalogue import published.csv -o published.json\n"
     "  eerie catalogue import giant-impacts.csv --radius 50 --fidelity survey\n"
     "  eerie catalogue compare published.csv --db published.sqlite",
     add_catalogue},
    {"fidelities", "Print the named settings, their cost and their error",
     "  eerie fidelities\n"
     "  eerie fidelities --json",
     add_fidelities},
    {"sizes", "Say and draw how many remnants there are above each mass",
     "  eerie sizes --db fig2b.sqlite --fidelity survey -o sizes.pdf\n"
     "  eerie sizes --class hit-and-run -o sizes.svg -o sizes.csv\n"
     "  eerie sizes --where job=12 --json",
     add_sizes},
    {"map", "Draw b/a, or another quantity, over impact speed and angle",
     "  eerie map -o map.png\n"
     "  eerie map --q 1 --phi-d 50 --fidelity survey -o map.pdf -o map.svg\n"
     "  eerie map --q 1 --phi-d 50 --quantity b/a,period,class -o panels.pdf\n"
     "  eerie map -o numbers.csv",
     add_map},
    {"threshold", "Fit v sin(theta) = constant to where elongated remnants form",
     "  eerie threshold\n"
     "  eerie threshold --db fig2b.sqlite --q 1 --phi-d 40 -o ridge.svg\n"
     "  eerie threshold --json",
     add_threshold},
    {"check", "Test what the paper says of impacts against a database",
     "  eerie check\n"
     "  eerie check --db fig2b.sqlite -o report.md\n"
     "  eerie check --json",
     add_check},
    {"odds", "Say how often collisions of a swarm leave an extremely elongated remnant",
     "  eerie odds --db fig2b.sqlite\n"
     "  eerie odds --q 1 --phi-d 50 --dispersion 10 --dispersion 20 --json\n"
     "  eerie odds -o odds.svg -o odds.csv",
     add_odds},
    {"converge", "Run impacts at rising particle numbers and draw how their results converge",
     "  eerie converge sweeps/studies/convergence.json --budget 2 -o convergence\n"
     "  eerie converge sweeps/studies/convergence.json --draw-only -o convergence",
     add_converge},
    {"chart", "Run impacts with one setting at a time changed and chart error against cost",
     "  eerie chart sweeps/studies/accuracy.json -o accuracy.svg\n"
     "  eerie chart sweeps/studies/accuracy.json --budget 2 -o accuracy.png\n"
     "  eerie chart sweeps/studies/accuracy.json --draw-only -o accuracy.pdf",
     add_chart},
    {"disk",
     "Say where in a protoplanetary disk impacts are slow enough, beside the paper's numbers",
     "  eerie disk\n"
     "  eerie disk --r 30 --alpha 1e-3 --json\n"
     "  eerie disk -o disk --format svg --format pdf",
     add_disk},
    {"help", "Say what a command does, and its options",
     "  eerie help\n"
     "  eerie help run\n"
     "  eerie help catalogue import",
     add_help},
    {"manual", "Print man pages, and completions for bash, zsh and fish",
     "  eerie manual run | man -l -\n"
     "  eerie manual --completion bash > ~/.local/share/bash-completion/completions/eerie\n"
     "  eerie manual -o manual",
     add_manual},
    {"worker", "Run the job of a directory", nullptr, add_worker},
    {"slurm-task", "Run the jobs of an array task of Slurm", nullptr, add_slurm_task},
};

/// CLI11 only says that a command is required; this says what is wrong with the word given.
void require_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  if (const std::string fault = manual::unknown_command(app, argv[1]); !fault.empty())
    throw InputError(fault);
}

int complaint(const char* text, int code) {
  complain(std::string("eerie: ") + text);
  return code;
}

int complaint(const char* text, ExitCode code) { return complaint(text, static_cast<int>(code)); }

/// Adds all commands; the one that is given sets `chosen`, and the format of the output.
void add_commands(CLI::App& app, Action& chosen, Output& out) {
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.description);
    if (command.examples == nullptr)
      sub->group("");
    else
      sub->footer(std::string("Examples:\n") + command.examples);
    sub->callback([&chosen, &out, sub, action = command.add(*sub)] {
      chosen = action;
      out.format = format_of(*sub);
    });
  }
}

/// --help and --version are answers, all else is a complaint.
int exit_of_parser(const CLI::App& app, const CLI::ParseError& error, Output& out) {
  if (error.get_exit_code() == 0) {
    std::ostringstream said;
    app.exit(error, said, said);
    out.write(said.str());
    return 0;
  }
  const std::string unknown = manual::unknown_options(app, sweeps::shared_field_paths());
  complain("eerie: " + (unknown.empty() ? manual::wrong_use(app, error) : unknown));
  return static_cast<int>(ExitCode::bad_input);
}

/// --version, and --version --json.
void add_version(CLI::App& app) {
  const CLI::Option* json = app.add_flag("--json")->description("with --version: print JSON");
  CLI::Option* version = app.set_version_flag("--version", [json] {
    const job_folder::Provenance made = job_folder::provenance();
    if (json->count() == 0)
      return fmt::format("eerie {} ({}), {}", made.version, made.commit, vector_variant);
    nlohmann::json document = job_folder::to_json(made);
    document.erase("host");
    document["vector"] = vector_variant;
    document["database_version"] = db::latest_version();
    return document.dump(1);
  });
  app.get_option("--json")->needs(version);
}

/// The parser would take the next word for the value that "--db=" lacks.
void require_values(int argc, char** argv) {
  for (int k = 1; k < argc && std::string_view(argv[k]) != "--"; ++k)
    if (const std::string_view word = argv[k]; word.starts_with("--") && word.ends_with('='))
      throw InputError(
          fmt::format("{}: has no value behind its sign; give one, or leave the option out", word));
}

int run_command(int argc, char** argv, Output& out) {
  CLI::App app(
      "eerie explores impacts of planetesimals that leave extremely elongated remnants (EERs).",
      "eerie");
  add_version(app);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 some job failed, 2 bad input, 3 environment, 130 stopped by Ctrl-C.\n"
      "`eerie help COMMAND` shows its options, and examples.");
  Action chosen;
  add_commands(app, chosen, out);
  require_plain_numbers(app);
  try {
    require_values(argc, argv);
    require_command(app, argc, argv);
    app.parse(argc, argv);
    const Answer answer = chosen(out);
    out.print(answer);
    return answer.exit_code;
  } catch (const CLI::ParseError& error) {
    return exit_of_parser(app, error, out);
  } catch (const InputError& error) {
    return complaint(error.what(), ExitCode::bad_input);
  } catch (const manager::StoppedBefore& error) {
    return complaint(error.what(), stopped_by_signal);
  } catch (const NumericalError& error) {
    return complaint(error.what(), ExitCode::job_failed);
  } catch (const std::exception& error) {
    // EnvironmentError, db::Error and whatever the system's libraries throw.
    return complaint(error.what(), ExitCode::environment);
  }
}

}  // namespace

int main(int argc, char** argv) {
  process::guard_standard_streams();
  Output out(STDOUT_FILENO);
  const int code = run_command(argc, argv, out);
  try {
    out.finish();
  } catch (const EnvironmentError& error) {
    return complaint(error.what(), ExitCode::environment);
  }
  return code;
}

}  // namespace eerie::cli
