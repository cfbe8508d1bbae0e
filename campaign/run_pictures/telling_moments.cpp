#include "campaign/run_pictures/telling_moments.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace eerie::run_pictures {

namespace {

constexpr std::size_t most = 5;
constexpr double soon = 0.25;  ///< part of the time from contact to separation

/// The first snapshot from `from` on for which the test holds; the number of all where none does.
std::size_t first_from(std::size_t from, std::size_t count,
                       const std::function<bool(std::size_t)>& holds) {
  while (from < count && !holds(from)) ++from;
  return from;
}

/// The snapshot nearest to the middle of two moments.
std::size_t in_the_middle(const std::vector<Moment>& course, std::size_t from, std::size_t to) {
  const double middle = (course[from].time + course[to].time) / 2;
  std::size_t best = from;
  for (std::size_t k = from; k < to; ++k)
    if (std::abs(course[k].time - middle) < std::abs(course[best].time - middle)) best = k;
  return best;
}

/// The snapshot that lies most nearly in the middle of the widest gap; `course.size()` where every
/// snapshot is taken.
std::size_t in_widest_gap(const std::vector<Moment>& course,
                          const std::vector<TellingMoment>& chosen) {
  std::size_t best = course.size();
  double widest = 0;
  for (std::size_t k = 0; k < course.size(); ++k) {
    double nearest = course.back().time - course.front().time + 1;
    for (const TellingMoment& m : chosen)
      nearest = std::min(nearest, std::abs(course[k].time - course[m.snapshot].time));
    if (nearest > widest) widest = nearest, best = k;
  }
  return best;
}

}  // namespace

std::vector<TellingMoment> telling_moments(const std::vector<Moment>& course) {
  const std::size_t n = course.size();
  if (n == 0) return {};
  std::vector<TellingMoment> chosen;
  const auto add = [&](std::size_t snapshot, std::string_view name) {
    if (snapshot < n && chosen.size() < most &&
        std::ranges::none_of(chosen,
                             [&](const TellingMoment& m) { return m.snapshot == snapshot; }))
      chosen.push_back({snapshot, name});
  };
  add(n - 1, "end");
  const std::size_t contact =
      first_from(0, n, [&](std::size_t k) { return course[k].bodies < course[0].bodies; });
  // A run whose first snapshot shows one body begins with the contact.
  const std::size_t one = contact < n ? contact : 0;
  const std::size_t apart =
      contact < n || course[0].bodies == 1
          ? first_from(one, n, [&](std::size_t k) { return course[k].bodies > course[one].bodies; })
          : n;
  add(contact, "contact");
  if (one < std::min(apart, n) && course[one].bodies == 1) {
    std::size_t longest = one;
    for (std::size_t k = one; k < apart; ++k)
      if (course[k].longest > course[longest].longest) longest = k;
    // Where it breaks at its longest the panel of the separation shows that.
    const bool breaks = apart < n && course[apart].time - course[longest].time <
                                         soon * (course[apart].time - course[one].time);
    if (breaks)
      add(in_the_middle(course, one, apart), "stretching");
    else
      add(longest, "longest");
  }
  add(apart, "first separation");
  if (apart < n)
    add(first_from(apart + 1, n,
                   [&](std::size_t k) { return course[k].bodies < course[k - 1].bodies; }),
        "fall-back");
  add(0, "start");
  while (chosen.size() < std::min(most, n)) add(in_widest_gap(course, chosen), "");
  std::ranges::sort(chosen, {}, &TellingMoment::snapshot);
  return chosen;
}

}  // namespace eerie::run_pictures
