#include "campaign/text/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "campaign/text/given_file.hpp"
#include "solver/base/error.hpp"

namespace eerie::text {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int max_depth = 32;
constexpr std::size_t most_document_bytes = 16 << 20;  // of any scene or sweep

/// "line 3, column 7" of a byte offset that counts from 1, as the parser gives it.
std::string position(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start =
      before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("line {}, column {}", line, before.size() - line_start + 1);
}

/// The parser's own words without its error number and position.
std::string without_prefix(const std::string& what) {
  for (const char* mark : {"syntax error", "attempting"})
    if (const std::size_t at = what.find(mark); at != std::string::npos) return what.substr(at);
  const std::size_t end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

/// Watches the parser's events for what the parser itself lets pass.
class Strict {
 public:
  explicit Strict(std::string name) : name_(std::move(name)) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (depth > max_depth)
      throw InputError(
          fmt::format("{}: nested deeper than {} levels; flatten it", name_, max_depth));
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw InputError(fmt::format("{}: the key {} stands twice in one object; remove one of them",
                                   name_, parsed.dump()));
    return true;
  }

 private:
  std::string name_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

json parse_json(std::string_view text, const std::string& name) {
  // The parser would take one for the end of the text.
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    throw InputError(
        fmt::format("{}, {}: not JSON: a NUL byte; remove it", name, position(text, nul + 1)));
  Strict strict(name);
  try {
    return json::parse(text, [&](int depth, json::parse_event_t event, json& parsed) {
      return strict(depth, event, parsed);
    });
  } catch (const json::parse_error& error) {
    throw InputError(fmt::format("{}, {}: not JSON: {}", name, position(text, error.byte),
                                 without_prefix(error.what())));
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: not JSON: {}", name, without_prefix(error.what())));
  }
}

json load_json(const fs::path& path) {
  std::error_code problem;
  if (fs::exists(path, problem) && !fs::is_regular_file(path, problem))
    throw InputError(path.string() + ": is no plain file");
  return load_given_json(path);
}

json load_given_json(const fs::path& path) {
  return parse_json(read_given(path, most_document_bytes), given_name(path));
}

template <class Whole>
void read_whole(const json& value, Whole& into) {
  constexpr double exact = 0x1p53;  // up to there a float holds every whole number
  const auto fits = [&] {
    if (value.is_number_unsigned()) return std::in_range<Whole>(value.get<std::uint64_t>());
    if (value.is_number_integer()) return std::in_range<Whole>(value.get<std::int64_t>());
    if (!value.is_number_float()) return false;
    const double number = value.get<double>();
    return number == std::floor(number) && std::abs(number) <= exact &&
           std::in_range<Whole>(static_cast<std::int64_t>(number));
  };
  if (!fits()) throw json::out_of_range::create(406, "no whole number that fits", &value);
  value.get_to(into);
}
template void read_whole(const json& value, int& into);
template void read_whole(const json& value, long& into);
template void read_whole(const json& value, unsigned long& into);

}  // namespace eerie::text
