#include "campaign/serve/reply.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "solver/base/error.hpp"

namespace eerie::serve {
namespace {

template <class T>
std::optional<T> parsed(const Parameters& parameters, const std::string& name, const char* kind) {
  const std::string text = word(parameters, name);
  if (text.empty()) return std::nullopt;
  T value{};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc() && end == text.data() + text.size() &&
      std::isfinite(static_cast<double>(value)))
    return value;
  throw InputError(fmt::format("{} = {}: must be {}", name, text, kind));
}

}  // namespace

void require_known(const Parameters& parameters, std::string_view known) {
  std::istringstream words{std::string(known)};
  const std::set<std::string> names{std::istream_iterator<std::string>(words), {}};
  for (const auto& [name, value] : parameters) {
    if (!names.contains(name))
      throw InputError(fmt::format(
          "parameter {}: this address {}", name,
          names.empty() ? "takes none" : fmt::format("takes {}", fmt::join(names, ", "))));
    if (name != "where" && parameters.count(name) > 1)
      throw InputError(fmt::format("parameter {}: is given twice", name));
  }
}

std::string word(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? "" : found->second;
}

std::optional<double> number(const Parameters& parameters, const std::string& name) {
  return parsed<double>(parameters, name, "a number");
}

std::optional<std::int64_t> whole_number(const Parameters& parameters, const std::string& name) {
  return parsed<std::int64_t>(parameters, name, "a whole number");
}

Reply json_reply(const nlohmann::json& document, int status) {
  using nlohmann::json;
  return {.status = status, .body = document.dump(-1, ' ', false, json::error_handler_t::replace)};
}

Reply refusal(int status, const std::string& why) { return json_reply({{"error", why}}, status); }

Reply busy(const std::string& why) {
  Reply reply = refusal(503, why);
  reply.retry_s = ask_again_s;
  return reply;
}

}  // namespace eerie::serve
