#pragma once

#include <CLI/CLI.hpp>

#include "campaign/serve/dashboard.hpp"

namespace eerie::cli {

/// --port, --listen and --read-only.
void add_dashboard(CLI::App& app, serve::DashboardOptions& options);

/// Prints where the dashboard is, and what listening beyond this machine means.
void print_address(const serve::Dashboard& dashboard, const serve::DashboardOptions& options);

}  // namespace eerie::cli
