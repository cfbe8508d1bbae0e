#pragma once

#include "campaign/cli/options/options.hpp"

namespace eerie::cli {

/// Adds the options of one command to its part of the command line and returns what it does. The
/// arguments live as long as the action.
using AddCommand = Action(CLI::App& app);

AddCommand add_run, add_expand, add_solve, add_analyse;
AddCommand add_daemon, add_submit, add_pause, add_resume, add_cancel, add_retry, add_priority,
    add_wall_limit, add_extend;
AddCommand add_status, add_serve, add_log, add_show, add_query, add_catalogue, add_sizes,
    add_doctor;
AddCommand add_converge, add_chart, add_threshold, add_check, add_odds, add_disk, add_lightcurve,
    add_map, add_remnant;
AddCommand add_init, add_help, add_manual, add_fidelities, add_merge, add_compare;
AddCommand add_worker, add_slurm_task;  // hidden

}  // namespace eerie::cli
