#include "campaign/cli/cli.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/options.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/slurm/array_task.hpp"
#include "campaign/worker/worker.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"
#include "solver/base/simd.hpp"

namespace eerie::cli {
namespace {

// Each function adds one command's options and gives what the command does. The arguments live
// as long as the action.

Action add_run(CLI::App& app) {
  auto a = std::make_shared<RunArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_share(app, a->workers, a->threads_per_job);
  add_changes(app, a->changes);
  app.add_option("--map", a->maps, "draw the b/a map into this file too (.png, .svg or .pdf)");
  app.add_flag("--retry-failed", a->retry_failed, "run the sweep's failed jobs again");
  app.add_option("--confidence", a->confidence,
                 "with --fidelity auto: how sure class and b/a < 0.3 must be (default: 0.9)")
      ->check(CLI::Range(0.5, 0.999));
  app.add_option("--budget", a->core_hours,
                 "with --fidelity auto: core-hours that it may cost (default: no limit)")
      ->check(CLI::Range(0.001, 1e7));
  app.add_option("--most-seeds", a->most_seeds,
                 "with --fidelity auto: surveys of one impact at most (default: 8)")
      ->check(CLI::Range(1, 1000));
  add_engine(app, a->engine);
  add_json(app, a->json);
  return [a] { return run(*a); };
}

Action add_expand(CLI::App& app) {
  auto a = std::make_shared<ExpandArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_changes(app, a->changes);
  app.add_flag("--list", a->list, "print every job");
  add_json(app, a->json);
  return [a] { return expand(*a); };
}

Action add_solve(CLI::App& app) {
  auto a = std::make_shared<SolveArguments>();
  app.add_option("SCENE", a->scene, "scene file")->required();
  app.add_option("--out", a->directory, "folder for snapshots, history and result")->required();
  app.add_option("--max-steps", a->max_steps, "stop after so many steps (default: at the end time)")
      ->check(CLI::Range(1L, 1'000'000'000'000L));
  app.add_option("--threads", a->threads, "threads (default: all cores)")
      ->check(CLI::Range(1, most_threads));
  add_changes(app, a->changes);
  add_json(app, a->json);
  return [a] { return solve(*a); };
}

Action add_worker(CLI::App& app) {
  auto a = std::make_shared<worker::WorkerOptions>();
  app.add_option("DIR", a->directory, "job directory")->required();
  app.add_option("--threads", a->threads, "threads")->check(CLI::Range(1, most_threads));
  app.add_option("--parent", a->parent, "process to end with");
  return [a] { return worker::run_worker(*a); };
}

Action add_slurm_task(CLI::App& app) {
  auto batch = std::make_shared<std::filesystem::path>();
  app.add_option("BATCH", *batch, "folder of the batch")->required();
  return [batch] { return slurm::run_array_task(slurm::array_task_options(*batch)); };
}

struct Command {
  const char* name;
  const char* description;
  const char* examples;  ///< nullptr: hidden from --help
  Action (*add)(CLI::App&);
};

constexpr Command commands[] = {
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
    {"status", "Count the jobs of each sweep, say what is left, group the failures",
     "  eerie status\n"
     "  eerie status --watch\n"
     "  eerie status --db fig2b.sqlite --json",
     add_status},
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
    {"log", "Print the log of a job", "  eerie log 3f9a20c1\n  eerie log 3f9a20c1 -f", add_log},
    {"doctor", "Look for damage: database, job directories, disk, versions",
     "  eerie doctor\n"
     "  eerie doctor --fix",
     add_doctor},
    {"query", "List results, remnants or points of the map",
     "  eerie query --eer\n"
     "  eerie query --phi-d 40 --v 18:22 --theta 15 --format csv\n"
     "  eerie query --class hit-and-run --json\n"
     "  eerie query --of remnants --where b_over_a=0:0.3 --sort=-mass_kg --limit 10\n"
     "  eerie query --of maps --columns v_imp_cm_per_s,theta_imp_deg,p_eer -o map.csv",
     add_query},
    {"catalogue", "Exchange impacts and outcomes with catalogues of collisions",
     "  eerie catalogue export --db fig2b.sqlite --fidelity survey -o fig2b.csv\n"
     "  eerie catalogue import published.csv -o published.json\n"
     "  eerie catalogue import giant-impacts.csv --radius 50 --fidelity survey\n"
     "  eerie catalogue compare published.csv --db published.sqlite",
     add_catalogue},
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
    {"worker", "Run the job of a directory", nullptr, add_worker},
    {"slurm-task", "Run the jobs of an array task of Slurm", nullptr, add_slurm_task},
};

/// CLI11 only says that a command is required; this says what is wrong with the word given.
void require_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names;
  for (const Command& command : commands) {
    if (std::string_view(command.name) == argv[1]) return;
    if (command.examples != nullptr) names += std::string(names.empty() ? "" : ", ") + command.name;
  }
  throw InputError(fmt::format("there is no command \"{}\"; the commands are {}", argv[1], names));
}

int complain(const char* text, ExitCode code) {
  fmt::print(stderr, "eerie: {}\n", text);
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "eerie explores impacts of planetesimals that leave extremely elongated remnants (EERs).",
      "eerie");
  app.set_version_flag("--version",
                       fmt::format("eerie {} ({}), {}", job_folder::provenance().version,
                                   job_folder::provenance().commit, vector_variant));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 some job failed, 2 bad input, 3 environment, 130 stopped by Ctrl-C.\n"
      "`eerie COMMAND --help` shows examples.");
  Action chosen;
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.description);
    if (command.examples == nullptr)
      sub->group("");
    else
      sub->footer(std::string("Examples:\n") + command.examples);
    sub->callback([&chosen, action = command.add(*sub)] { chosen = action; });
  }
  require_finite_numbers(app);
  try {
    require_command(argc, argv);
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    const bool asked_for = error.get_exit_code() == 0;  // --help, --version
    return app.exit(error) == 0 && asked_for ? 0 : static_cast<int>(ExitCode::bad_input);
  } catch (const InputError& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const NumericalError& error) {
    return complain(error.what(), ExitCode::job_failed);
  } catch (const std::exception& error) {
    // EnvironmentError, db::Error and whatever the system's libraries throw.
    return complain(error.what(), ExitCode::environment);
  }
}

}  // namespace eerie::cli
