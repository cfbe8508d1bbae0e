#include "campaign/slurm/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <regex>

#include "campaign/slurm/profile_schema_text.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::slurm {
using nlohmann::json;

namespace {

/// An array task that is told to stop at once would never get on.
constexpr std::chrono::seconds least_work{60};

/// What eerie says to sbatch itself, or what would keep it from finding its jobs again.
constexpr std::array reserved = {
    "--parsable",   "--array",  "-a",        "--requeue", "--no-requeue", "--open-mode",
    "--signal",     "--output", "-o",        "--error",   "-e",           "--job-name",
    "-J",           "--wrap",   "--wait",    "-W",        "--test-only",  "--chdir",
    "-D",           "--ntasks", "-n",        "--hold",    "-H",           "--cpus-per-task",
    "-c",           "--time",   "-t",        "--mem",     "--uid",        "--clusters",
    "-M",           "--help",   "--usage",   "--version", "-V",           "-h",
    "--partition",  "-p",       "--account", "-A",        "--qos",        "-q",
    "--constraint", "-C"};

const json& schema() {
  static const json parsed = json::parse(slurm_profile_schema_text);
  return parsed;
}

std::string in_quotes(const std::string& text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// A line break or another control character in an option would end up in the cluster's records.
void require_one_line(const std::string& text, const std::string& where) {
  if (std::ranges::any_of(text, [](unsigned char c) { return c < ' ' || c == 127; }))
    throw InputError(
        fmt::format("{} = {}: must be one line without control characters; remove them", where,
                    in_quotes(text)));
}

std::string one_line(const json& document, const char* key, const std::string& where) {
  const std::string text = document.value(key, "");
  require_one_line(text, where + "." + key);
  if (document.contains(key) && text.empty())
    throw InputError(
        fmt::format("{}.{} = \"\": must not be empty; remove the field to leave the "
                    "choice to the cluster",
                    where, key));
  return text;
}

bool is_reserved(const std::string& option) {
  if (!option.starts_with("--"))  // "-J name" is written "-Jname"
    return std::ranges::any_of(reserved, [&](const std::string_view word) {
      return word.size() == 2 && option.starts_with(word);
    });
  const std::string name = option.substr(0, option.find('='));
  // sbatch takes any unambiguous beginning of an option for it. "--wait" is not "--wait-all-nodes".
  return std::ranges::any_of(reserved,
                             [&](const std::string_view word) { return word.starts_with(name); });
}

void require_extra(const std::string& option, const std::string& where) {
  require_one_line(option, where);
  const bool option_like =
      option.size() >= 2 && option[0] == '-' && option != "--" &&
      (option[1] == '-' || std::isalpha(static_cast<unsigned char>(option[1])));
  if (!option_like)
    throw InputError(
        fmt::format("{} = {}: must be an option in one word; for example "
                    "\"--exclude=n17\"",
                    where, in_quotes(option)));
  if (is_reserved(option))
    throw InputError(fmt::format(
        "{} = {}: eerie sets this option of sbatch itself, from the profile's other fields or for "
        "its own use; remove it",
        where, in_quotes(option)));
}

}  // namespace

std::optional<std::chrono::seconds> parse_time_limit(const std::string& text) {
  static const std::regex days("(\\d{1,4})-(\\d{1,4})(?::(\\d{1,4}))?(?::(\\d{1,4}))?");
  static const std::regex hours("(\\d{1,6}):(\\d{1,4}):(\\d{1,4})");
  static const std::regex minutes("(\\d{1,6})(?::(\\d{1,4}))?");
  std::smatch m;
  const auto part = [&](std::size_t k) { return m[k].matched ? std::stol(m[k]) : 0L; };
  long seconds = 0;
  if (std::regex_match(text, m, days))
    seconds = ((part(1) * 24 + part(2)) * 60 + part(3)) * 60 + part(4);
  else if (std::regex_match(text, m, hours))
    seconds = (part(1) * 60 + part(2)) * 60 + part(3);
  else if (std::regex_match(text, m, minutes))
    seconds = part(1) * 60 + part(2);
  return seconds > 0 ? std::optional(std::chrono::seconds(seconds)) : std::nullopt;
}

SlurmProfile parse_slurm_profile(const json& given, const std::string& where) {
  const std::string path = where + ": profile";
  require_valid(schema(), given, path);
  const json document = with_defaults(schema(), given);
  SlurmProfile p;
  p.partition = one_line(document, "partition", path);
  p.account = one_line(document, "account", path);
  p.qos = one_line(document, "qos", path);
  p.constraint = one_line(document, "constraint", path);
  p.memory = one_line(document, "memory", path);
  if (!p.memory.empty() && !std::regex_match(p.memory, std::regex("\\d{1,12}[KMGT]?")))
    throw InputError(fmt::format(
        "{}.memory = {}: must be a number of megabytes, or a number and one of K, M, G, T; for "
        "example \"2G\"",
        path, in_quotes(p.memory)));
  p.cpus_per_task = document.at("cpus_per_task");
  p.extra_sbatch_options = document.at("extra_sbatch_options").get<std::vector<std::string>>();
  for (std::size_t k = 0; k < p.extra_sbatch_options.size(); ++k)
    require_extra(p.extra_sbatch_options[k], fmt::format("{}.extra_sbatch_options[{}]", path, k));
  if (document.contains("max_array_size")) p.max_array_size = document["max_array_size"];
  p.max_queued = document.at("max_queued");
  p.minutes_per_array_task = document.at("minutes_per_array_task");
  p.signal_before_end_s = document.at("signal_before_end_s");
  p.poll_interval_s = document.at("poll_interval_s");
  p.listed_within_s = document.at("listed_within_s");
  if (const std::string time = one_line(document, "time", path); !time.empty()) {
    p.time_limit = parse_time_limit(time);
    if (!p.time_limit)
      throw InputError(fmt::format(
          "{}.time = {}: must be MIN, MIN:SS, HH:MM:SS, D-HH, D-HH:MM or D-HH:MM:SS, and more than "
          "nothing; for example \"02:00:00\"",
          path, in_quotes(time)));
    const std::chrono::seconds least = std::chrono::seconds(p.signal_before_end_s) + least_work;
    if (*p.time_limit < least)
      throw InputError(fmt::format(
          "{}.time = {}: must be at least {} s, which is signal_before_end_s and {} s of work; "
          "raise it or lower signal_before_end_s",
          path, in_quotes(time), least.count(), least_work.count()));
  }
  return p;
}

SlurmProfile load_slurm_profile(const std::filesystem::path& path) {
  return parse_slurm_profile(text::load_given_json(path), text::given_name(path));
}

}  // namespace eerie::slurm
