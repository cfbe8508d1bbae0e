#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace eerie {

/// The named stages of a step, in the order in which they run, and what comes between steps:
/// output, and looks at the remnants with what they lead to (flights). Timing, printing and result
/// files all use this one table.
enum class Stage : std::size_t {
  integrate,
  reorder,
  neighbours,
  material,
  pairs,
  gravity,
  output,
  looks,
  count
};
inline constexpr std::size_t stage_count = static_cast<std::size_t>(Stage::count);
inline constexpr std::array<std::string_view, stage_count> stage_names = {
    "integrate", "reorder", "neighbours", "material", "pairs", "gravity", "output", "looks"};

/// The wall time spent in each stage, s.
struct StageTimes {
  std::array<double, stage_count> seconds{};
  double total() const {
    double sum = 0;
    for (double s : seconds) sum += s;
    return sum;
  }
};

/// Adds the time between construction and destruction to one stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, Stage stage)
      : seconds_(times.seconds[static_cast<std::size_t>(stage)]), start_(Clock::now()) {}
  ~StageTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_;
};

}  // namespace eerie
