#pragma once

#include <string_view>
#include <vector>

namespace eerie::run_pictures {

/// What a snapshot shows of the course of an impact.
struct Moment {
  double time = 0;         ///< s
  std::size_t bodies = 1;  ///< remnants, or the largest clump alone
  double longest = 0;      ///< the greatest extent of the largest body in the plane of the orbit, m
};

/// A moment worth a panel.
struct TellingMoment {
  std::size_t snapshot = 0;
  std::string_view name = {};  ///< "contact", "longest", "first separation", "fall-back", "end"...
};

/// At most five moments in order of time, each snapshot once. They are contact (both bodies are one
/// clump), the longest body before the first separation (half-way to it where it breaks soon
/// after), that separation (more bodies than before), the first fall-back after it (fewer bodies
/// than just before), and the end. Where fewer happen, the start and moments in the widest gaps
/// join them.
std::vector<TellingMoment> telling_moments(const std::vector<Moment>& course);

}  // namespace eerie::run_pictures
