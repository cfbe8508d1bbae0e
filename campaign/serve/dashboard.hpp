#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace eerie::serve {

struct DashboardOptions {
  std::filesystem::path database;
  int port = 8765;           ///< 0: any that is free
  std::string address = {};  ///< to listen on; empty: 127.0.0.1
  bool read_only = false;
};

/// The dashboard of a database, from its making to its end, in threads of its own.
class Dashboard {
 public:
  /// Throws EnvironmentError where the port cannot be had, db::Error where the database cannot.
  explicit Dashboard(const DashboardOptions& options);
  ~Dashboard();
  Dashboard(const Dashboard&) = delete;
  Dashboard& operator=(const Dashboard&) = delete;

  /// With the token behind #, which browsers keep to themselves.
  std::string address() const;
  int port() const;
  const std::string& token() const;

 private:
  class Running;
  std::unique_ptr<Running> running_;
};

}  // namespace eerie::serve
