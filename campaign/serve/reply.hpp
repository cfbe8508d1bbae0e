#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace eerie::serve {

/// The parameters after the ? of an address.
using Parameters = std::multimap<std::string, std::string>;

/// Throws InputError, which names the parameter, where one is none of these (words with blanks
/// between them) or is given twice. `where` may be repeated: all of its conditions hold.
void require_known(const Parameters& parameters, std::string_view known);

/// The first value of a parameter; empty where there is none.
std::string word(const Parameters& parameters, const std::string& name);
/// The number of a parameter; nothing where it is missing or empty. Throws InputError where it is
/// no finite number.
std::optional<double> number(const Parameters& parameters, const std::string& name);
/// The integer of a parameter, in the same way.
std::optional<std::int64_t> whole_number(const Parameters& parameters, const std::string& name);

struct Reply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::string etag = {};       ///< identifies the content; empty: browsers keep no copy
  std::string file_name = {};  ///< name of the file to save; empty: browsers show the content
  int retry_s = 0;             ///< when to ask again; 0: not said
};

/// A reply of JSON. Bytes that are not UTF-8 become replacement characters.
Reply json_reply(const nlohmann::json& document, int status = 200);
/// A reply {"error": reason}.
Reply refusal(int status, const std::string& why);
/// A refusal with 503, and when to ask again.
Reply busy(const std::string& why);
inline constexpr int ask_again_s = 5;

}  // namespace eerie::serve
