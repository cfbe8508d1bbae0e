#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::test {

/// A campaign of tiny real impacts that is disturbed, and the same one left in peace.
class DisturbedCampaign {
 public:
  /// Submits `jobs` impacts of `end_time_s` (about a second per 10,000 s); the folder may be on a
  /// disk of its own.
  DisturbedCampaign(const std::filesystem::path& folder, int jobs, double end_time_s);
  /// The same, not submitted: the folder holds as much of it as it does.
  struct AsItIs {};
  DisturbedCampaign(const std::filesystem::path& folder, int jobs, double end_time_s, AsItIs);

  /// Submits it (again).
  void submit() const;
  std::vector<std::string> daemon_words() const;
  /// Lets a daemon work until nothing is left, trying again what crashed too often.
  void finish_in_peace() const;

  /// Fails the test unless every job is done exactly once, with the results of an undisturbed
  /// campaign, and neither database nor directories are damaged.
  void expect_whole() const;

  int number(const std::string& sql) const;
  bool everything_is_done() const;
  /// Process ids of workers that hold a job directory.
  std::vector<pid_t> workers() const;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path database() const { return folder_ / "eerie.sqlite"; }

 private:
  std::filesystem::path folder_;
  int jobs_;
  double end_time_s_;
};

/// An environment variable for programs that start while it lives.
class Environment {
 public:
  Environment(const char* name, const std::string& value);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

/// A whole number from the environment, or the default: how long a storm lasts.
int from_environment(const char* name, int otherwise);

}  // namespace eerie::test
