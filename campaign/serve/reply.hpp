#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace eerie::serve {

/// What stands behind the ? of an address.
using Parameters = std::multimap<std::string, std::string>;

/// The first value of a parameter; empty where there is none.
std::string word(const Parameters& parameters, const std::string& name);
/// Nothing where it is missing or empty. Throws InputError for what is no finite number.
std::optional<double> number(const Parameters& parameters, const std::string& name);
/// The same for whole numbers.
std::optional<std::int64_t> whole_number(const Parameters& parameters, const std::string& name);

struct Reply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::string etag = {};       ///< names the content; empty: is not kept by browsers
  std::string file_name = {};  ///< to be saved under; empty: to be shown
};

/// Text that is no UTF-8 is written with replacement characters.
Reply json_reply(const nlohmann::json& document, int status = 200);
/// {"error": why}
Reply refusal(int status, const std::string& why);

}  // namespace eerie::serve
