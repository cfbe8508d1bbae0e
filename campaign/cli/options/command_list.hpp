#pragma once

#include "campaign/cli/options/options.hpp"

namespace eerie::cli {

// Each adds one command's options to its part of the command line and gives what it does. The
// arguments live as long as the action.

Action add_run(CLI::App& app);
Action add_expand(CLI::App& app);
Action add_solve(CLI::App& app);
Action add_analyse(CLI::App& app);
Action add_daemon(CLI::App& app);
Action add_submit(CLI::App& app);
Action add_pause(CLI::App& app);
Action add_resume(CLI::App& app);
Action add_cancel(CLI::App& app);
Action add_retry(CLI::App& app);
Action add_priority(CLI::App& app);
Action add_wall_limit(CLI::App& app);
Action add_status(CLI::App& app);
Action add_serve(CLI::App& app);
Action add_log(CLI::App& app);
Action add_show(CLI::App& app);
Action add_query(CLI::App& app);
Action add_catalogue(CLI::App& app);
Action add_sizes(CLI::App& app);
Action add_doctor(CLI::App& app);
Action add_converge(CLI::App& app);
Action add_chart(CLI::App& app);
Action add_threshold(CLI::App& app);
Action add_check(CLI::App& app);
Action add_disk(CLI::App& app);
Action add_lightcurve(CLI::App& app);
Action add_map(CLI::App& app);
Action add_manual(CLI::App& app);
Action add_worker(CLI::App& app);      ///< hidden
Action add_slurm_task(CLI::App& app);  ///< hidden

}  // namespace eerie::cli
