#include "campaign/slurm/queue_text.hpp"

#include <fmt/format.h>

#include <charconv>

namespace eerie::slurm {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// What stands before `mark`, which is cut off `text` with it; all where there is no mark.
std::string_view cut(std::string_view& text, char mark) {
  const std::size_t at = text.find(mark);
  const std::string_view head = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view{} : text.substr(at + 1);
  return head;
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (text.empty() || problem != std::errc{} || stop != end || value < 0) return std::nullopt;
  return value;
}

constexpr int most_indices = 4'000'001;  // no cluster allows more

/// "3", "3-7" or "0-8:2" into `array`; false where it is none of them.
bool add_range(std::string_view text, const std::string& state, QueuedArray& array) {
  std::string_view step_text = text;
  std::string_view range = cut(step_text, ':');
  const bool has_step = range.size() != text.size();
  std::string_view last_text = range;
  const std::string_view first_text = cut(last_text, '-');
  const auto first = number<int>(first_text);
  const auto last = first_text.size() == range.size() ? first : number<int>(last_text);
  const auto step = has_step ? number<int>(step_text) : std::optional(1);
  if (!first || !last || !step || *step == 0 || *last > most_indices) return false;
  for (int index = *first; index <= *last; index += *step) array.states[index] = state;
  return true;
}

void add_indices(std::string_view text, const std::string& state, QueuedArray& array) {
  if (text.starts_with('[')) {
    text.remove_prefix(1);
    text = cut(text, ']');
    text = cut(text, '%');  // how many may run at a time
  }
  while (!text.empty())
    if (!add_range(trimmed(cut(text, ',')), state, array)) array.more = true;
}

}  // namespace

std::optional<SlurmJobId> submitted_id(std::string_view text) {
  text = trimmed(text);
  const std::size_t line = text.rfind('\n');
  if (line != std::string_view::npos) text = text.substr(line + 1);
  const auto id = number<std::int64_t>(trimmed(cut(text, ';')));
  if (!id) return std::nullopt;
  return SlurmJobId{*id, std::string(trimmed(text))};
}

Queue parse_queue(std::string_view text) {
  Queue queue;
  while (!text.empty()) {
    std::string_view line = trimmed(cut(text, '\n'));
    std::string_view ids = cut(line, '|');
    const std::string state(trimmed(cut(line, '|')));
    const bool is_array = ids.find('_') != std::string_view::npos;
    const auto id = number<std::int64_t>(trimmed(cut(ids, '_')));
    if (!id) continue;  // no job of ours
    QueuedArray& array = queue[*id];
    array.name = trimmed(line);
    if (is_array)
      add_indices(trimmed(ids), state, array);
    else
      array.more = true;
  }
  return queue;
}

std::string index_ranges(const std::vector<int>& sorted) {
  std::string text;
  for (std::size_t k = 0; k < sorted.size();) {
    std::size_t last = k;
    while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text +=
        last == k ? fmt::format("{}", sorted[k]) : fmt::format("{}-{}", sorted[k], sorted[last]);
    k = last + 1;
  }
  return text;
}

std::optional<int> max_array_size(std::string_view config) {
  while (!config.empty()) {
    std::string_view value = cut(config, '\n');
    if (trimmed(cut(value, '=')) == "MaxArraySize") return number<int>(trimmed(value));
  }
  return std::nullopt;
}

}  // namespace eerie::slurm
