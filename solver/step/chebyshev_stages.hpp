#pragma once

#include <vector>

namespace eerie::step {

/// Follows y' = F(y) over a step dt by stages that each evaluate F once, as far as F damps: the
/// Runge-Kutta-Chebyshev method of first order (Verwer, Hundsdorfer & Sommeijer 1990, Numer. Math.
/// 57, 157, sec. 2). s stages stay stable up to about s^2 times the rate of damping that one does.
/// In terms of the change u_j = y_j - y_0 since the start of the step:
///   u_1 = first dt F(y_0),   u_j = last u_(j-1) + before u_(j-2) + step dt F(y_(j-1)),   u_0 = 0.
class ChebyshevStages {
 public:
  /// At least one; one is a step of Euler's.
  explicit ChebyshevStages(int count = 1) : w_(count > 1 ? 1 + damping / (count * count) : 1) {
    T_ = {1, w_};
    std::vector<double> slope = {0, 1};
    for (int j = 2; j <= count; ++j) {
      const std::size_t n = T_.size();
      T_.push_back(2 * w_ * T_[n - 1] - T_[n - 2]);
      slope.push_back(2 * T_[n - 1] + 2 * w_ * slope[n - 1] - slope[n - 2]);
    }
    scale_ = T_.back() / slope.back();
  }

  int count() const { return static_cast<int>(T_.size()) - 1; }
  /// The fastest damping that stays stable, over that of one stage, which is 2/dt.
  double reach() const { return (w_ + 1) / scale_ / 2; }
  double first() const { return scale_ / w_; }

  struct Weights {
    double last, before, step;
  };
  /// Of stage j, from 2 to count().
  Weights weights(int j) const {
    const auto at = static_cast<std::size_t>(j);
    return {2 * w_ * T_[at - 1] / T_[at], -T_[at - 2] / T_[at], 2 * scale_ * T_[at - 1] / T_[at]};
  }

 private:
  /// What is stable at all falls to 0.36 of it at most. With less damping, rubble does not come to
  /// rest.
  static constexpr double damping = 1.5;
  double w_, scale_;
  std::vector<double> T_;  ///< Chebyshev polynomials T_0(w), T_1(w)...
};

}  // namespace eerie::step
