#include "campaign/serve/reply.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

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

}  // namespace eerie::serve
