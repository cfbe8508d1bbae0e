#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

#include "db/store/connection.hpp"

namespace eerie::manager {

/// A stop was asked for before the work had begun.
struct StoppedBefore : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While it lives, the database is waited for only half a second at a time, so that a stop request
/// is heard in between.
class LessPatience {
 public:
  explicit LessPatience(db::Connection& connection);
  ~LessPatience();
  LessPatience(const LessPatience&) = delete;
  LessPatience& operator=(const LessPatience&) = delete;

 private:
  db::Connection& connection_;
};

/// Calls `write` again and again while another program holds the database open for writing; `note`
/// is told once that it does. Throws StoppedBefore where a stop is asked for meanwhile.
void when_free(db::Connection& connection, const std::function<void()>& write,
               const std::function<void(const std::string&)>& note);

}  // namespace eerie::manager
