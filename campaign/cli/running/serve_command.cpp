#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/running/serve_options.hpp"
#include "campaign/process/signals.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {

struct ServeArguments {
  serve::DashboardOptions dashboard;
  bool open = false;
};

/// Shows the address in the user's browser; who has none reads it.
void open_browser(const std::string& address) {
  const pid_t child = ::fork();
  if (child < 0) return;
  if (child == 0) {
    // A grandchild, so that the browser is nobody's to wait for.
    if (::fork() == 0) {
      ::execlp("xdg-open", "xdg-open", address.c_str(), nullptr);
      ::_exit(127);
    }
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
}

Answer serve_database(const ServeArguments& a, Output& out) {
  process::catch_stop_signals();
  process::hold_signals();
  const serve::Dashboard dashboard(a.dashboard);
  print_address(dashboard, a.dashboard, out);
  if (a.open) open_browser(dashboard.address());
  while (process::stop_requests() == 0) process::wait_for_signal(std::chrono::hours(1));
  return {};
}

}  // namespace

void add_dashboard(CLI::App& app, serve::DashboardOptions& options) {
  app.add_option("--port", options.port, "of the dashboard; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option(
      "--listen", options.address,
      "address of the dashboard (default: 127.0.0.1, this machine alone); at another one "
      "everybody who reaches it reads the database, and the token can be overheard");
  app.add_flag("--read-only", options.read_only, "the dashboard shows, and changes nothing");
}

void print_address(const serve::Dashboard& dashboard, const serve::DashboardOptions& options,
                   Output& out) {
  out.write(fmt::format("dashboard: {}\n", dashboard.address()));
  const bool beyond = !options.address.empty() && options.address != "127.0.0.1" &&
                      options.address != "::1" && options.address != "localhost";
  if (beyond)
    complain(fmt::format(
        "note: whoever reaches {} port {} reads this database{}; nothing is encrypted. "
        "`ssh -L {}:localhost:{} HOST` needs no --listen",
        options.address, dashboard.port(),
        options.read_only ? "" : ", and changes it with the token, which can be overheard",
        dashboard.port(), dashboard.port()));
}

Action add_serve(CLI::App& app) {
  auto a = std::make_shared<ServeArguments>();
  add_database(app, a->dashboard.database);
  add_dashboard(app, a->dashboard);
  app.add_flag("--open", a->open, "show it in the browser");
  return [a](Output& out) { return serve_database(*a, out); };
}

}  // namespace eerie::cli
