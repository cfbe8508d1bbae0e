#pragma once

#include <string>
#include <utility>
#include <vector>

namespace eerie::process {

/// A user's program that is told of events. No shell takes part: it gets the event as its one
/// argument, and facts as variables of its environment.
class Hook {
 public:
  /// Empty: none, and nothing is told. Throws InputError where there is no such program.
  explicit Hook(const std::string& program);

  using Facts = std::vector<std::pair<std::string, std::string>>;  ///< {"EERIE_DONE", "15"}
  /// Starts the program and does not wait for it. Its input is empty, its output is standard
  /// error. Returns why it could not be started, or nothing.
  std::string tell(const std::string& event, const Facts& facts) const;

 private:
  std::string path_;
};

}  // namespace eerie::process
