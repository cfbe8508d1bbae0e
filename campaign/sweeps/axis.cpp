#include "campaign/sweeps/axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/error.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

/// Decimals of the shortest text that reads back as `value`: 7.5 has 1, 1e-3 has 3.
int decimals(double value) {
  const std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  const std::string mantissa = text.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const int fraction =
      point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  const int shift = exponent == std::string::npos ? 0 : std::atoi(text.c_str() + exponent + 1);
  return std::max(0, fraction - shift);
}

double number(const json& spec, const char* key, const std::string& where) {
  if (!spec.contains(key))
    throw InputError(
        fmt::format("{}: the field \"{}\" is missing; an axis is a list of numbers or "
                    "{{\"from\": 12, \"to\": 36, \"step\": 3}}",
                    where, key));
  if (!spec[key].is_number())
    throw InputError(fmt::format("{}.{} = {}: must be a number; for example 3", where, key,
                                 spec[key].dump(-1, ' ', false, json::error_handler_t::replace)));
  return canonical_number(spec[key].get<double>()).get<double>();
}

std::vector<json> canonical(const std::vector<double>& numbers) {
  std::vector<json> values;
  values.reserve(numbers.size());
  for (const double number : numbers) values.push_back(canonical_number(number));
  return values;
}

std::vector<json> range_values(const json& spec, const std::string& where) {
  for (const auto& [key, ignored] : spec.items())
    if (key != "from" && key != "to" && key != "step")
      throw InputError(
          fmt::format("{}.{}: there is no such field; an axis has from, to and step", where, key));
  const double from = number(spec, "from", where), to = number(spec, "to", where);
  return canonical(inclusive_range(from, to, number(spec, "step", where), where));
}

std::vector<json> list_values(const json& spec, bool of_numbers, const std::string& where) {
  if (spec.empty())
    throw InputError(where + (of_numbers ? " = []: must hold at least one number; for example [20]"
                                         : " = []: must hold at least one value"));
  std::vector<json> values;
  std::set<json> seen;
  for (std::size_t i = 0; i < spec.size(); ++i) {
    if (of_numbers && !spec[i].is_number())
      throw InputError(fmt::format("{}[{}] = {}: must be a number; for example 20", where, i,
                                   spec[i].dump(-1, ' ', false, json::error_handler_t::replace)));
    values.push_back(of_numbers ? canonical_number(spec[i].get<double>()) : spec[i]);
    if (!seen.insert(values.back()).second)
      throw InputError(fmt::format("{}[{}] = {}: stands twice in the list; remove one of them",
                                   where, i, spec[i].dump()));
  }
  return values;
}

}  // namespace

std::vector<double> inclusive_range(double from, double to, double step, const std::string& where) {
  if (!(step > 0))
    throw InputError(
        fmt::format("{}.step = {}: must be a number greater than 0; for example 1", where, step));
  if (to < from)
    throw InputError(fmt::format("{}.to = {}: must be at least from = {}; swap them or raise it",
                                 where, to, from));
  const int digits = std::max(decimals(from), decimals(step));
  // Beyond 300 decimals nothing physical is meant, and the text would not fit a double.
  const auto value = [&](double k) {
    const std::string text = fmt::format("{:.{}f}", from + k * step, std::min(digits, 300));
    return canonical_number(std::strtod(text.c_str(), nullptr)).get<double>();
  };
  const double count = (to - from) / step;
  if (!(count < static_cast<double>(max_sweep_jobs)))
    throw InputError(fmt::format("{}.step = {}: makes more than {} values from {} to {}; raise it",
                                 where, step, max_sweep_jobs, from, to));
  const double last = std::round(count);
  if (value(last) != to)
    throw InputError(
        fmt::format("{}.to = {}: is not from + k * step; the nearest that fit are {} and {}", where,
                    to, value(std::floor(count)), value(std::floor(count) + 1)));
  std::vector<double> values;
  for (double k = 0; k <= last; ++k) values.push_back(value(k));
  if (std::adjacent_find(values.begin(), values.end()) != values.end())
    throw InputError(fmt::format(
        "{}.step = {}: is too small beside from = {} to tell two values apart", where, step, from));
  return values;
}

Axis parse_axis(const std::string& name, const json& spec, const std::string& where) {
  const SceneField field = scene_field(name, where);
  if (field.schema->value("type", "") == "array")
    throw InputError(fmt::format(
        "{}: an axis must be a field of one value and \"{}\" is a list; put it into \"scene\" "
        "instead",
        where, field.path));
  if (field.path.starts_with("output."))
    throw InputError(
        fmt::format("{}: what a run writes does not make it another run, so {} cannot be an "
                    "axis; put it into \"scene\" instead",
                    where, field.path));
  Axis axis{field.path, {}};
  const bool of_numbers = is_numeric(field);
  if (spec.is_object() && of_numbers)
    axis.values = range_values(spec, where);
  else if (spec.is_array())
    axis.values = list_values(spec, of_numbers, where);
  else
    throw InputError(fmt::format(
        "{} = {}: must be a list of {}", where,
        spec.dump(-1, ' ', false, json::error_handler_t::replace),
        of_numbers ? "numbers or {\"from\": 12, \"to\": 36, \"step\": 3}"
                   : fmt::format("values; for example [{}]", (*field.schema)["default"].dump())));
  for (std::size_t i = 0; i < axis.values.size(); ++i)
    require_valid(*field.schema, axis.values[i], fmt::format("{}[{}]", where, i));
  return axis;
}

}  // namespace eerie::sweeps
