#include "solver/base/kill_point.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <charconv>
#include <cstdlib>
#include <string>

#include "solver/base/error.hpp"

namespace eerie {

namespace {

constexpr const char* variable = "EERIE_KILL_AT";

struct Armed {
  std::string name, file;         ///< file: empty: any
  std::atomic<long> passings{0};  ///< that are left, this one included
} armed;

/// Read at the first passing, not here: nobody could catch what a wrong name throws.
const char* const from_environment = std::getenv(variable);

void arm_from_environment() {
  static const bool once = [] {
    if (from_environment && armed.name.empty()) arm_kill_point(from_environment);
    return true;
  }();
  (void)once;
}

}  // namespace

bool kill_points_are_armed = from_environment != nullptr;

void arm_kill_point(std::string_view where) {
  std::string_view rest = where;
  long passings = 1;
  if (const std::size_t colon = rest.rfind(':'); colon != std::string_view::npos) {
    const std::string_view digits = rest.substr(colon + 1);
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), passings);
    if (error != std::errc() || end != digits.end() || passings < 1)
      throw InputError(fmt::format("kill point '{}': '{}' is no count", where, digits));
    rest = rest.substr(0, colon);
  }
  const std::size_t at = rest.find('@');
  const std::string_view name = rest.substr(0, at);
  if (!is_kill_point(name))
    throw InputError(fmt::format("kill point '{}': there is none of that name; known: {}", where,
                                 fmt::join(kill_point_names, ", ")));
  armed.name = name;
  armed.file = at == std::string_view::npos ? "" : rest.substr(at + 1);
  armed.passings = passings;
  // Other threads read it without a lock; armed from the environment, it is true from the start.
  if (!kill_points_are_armed) kill_points_are_armed = true;
}

void pass_kill_point(std::string_view name, std::string_view file) {
  arm_from_environment();
  if (name != armed.name || (!armed.file.empty() && file != armed.file)) return;
  if (--armed.passings == 0) ::raise(SIGKILL);
}

}  // namespace eerie
