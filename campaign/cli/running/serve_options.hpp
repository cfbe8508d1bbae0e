#pragma once

#include <CLI/CLI.hpp>

#include "campaign/cli/output/output.hpp"
#include "campaign/serve/dashboard.hpp"

namespace eerie::cli {

/// Adds --port, --listen and --read-only.
void add_dashboard(CLI::App& app, serve::DashboardOptions& options);

/// Prints the address of the dashboard, and what listening beyond this machine means.
void print_address(const serve::Dashboard& dashboard, const serve::DashboardOptions& options,
                   Output& out);

}  // namespace eerie::cli
