#include "analysis/statistics/logistic_surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace eerie::statistics {
namespace {

using Row = std::array<double, 6>;

/// By elimination with pivots.
double determinant(std::array<Row, 6> m) {
  double product = 1;
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < 6; ++i)
      if (std::abs(m[i][k]) > std::abs(m[best][k])) best = i;
    if (best != k) std::swap(m[best], m[k]), product = -product;
    product *= m[k][k];
    for (std::size_t i = k + 1; i < 6; ++i)
      for (std::size_t j = 5; j + 1 > k; --j) m[i][j] -= m[k][j] * m[i][k] / m[k][k];
  }
  return product;
}

/// Log likelihood and half the log determinant of the information, straight from the definition.
double penalised(const LogisticSurface& s, const std::vector<Trials>& trials) {
  std::array<Row, 6> information{};
  double sum = 0;
  for (const Trials& t : trials) {
    const Row f = {1, t.x, t.y, t.x * t.x, t.x * t.y, t.y * t.y};
    const double p = s.p(t.x, t.y);
    sum += t.hits * std::log(p) + (t.runs - t.hits) * std::log(1 - p);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) information[i][j] += t.runs * p * (1 - p) * f[i] * f[j];
  }
  return sum + 0.5 * std::log(determinant(information));
}

std::vector<Trials> sampled(const LogisticSurface& truth, int along, double runs,
                            std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Trials> trials;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < along; ++j) {
      const double x = -3 + 6.0 * i / (along - 1), y = -3 + 6.0 * j / (along - 1);
      std::binomial_distribution<int> hits(static_cast<int>(runs), truth.p(x, y));
      trials.push_back({x, y, static_cast<double>(hits(random)), runs});
    }
  return trials;
}

constexpr LogisticSurface ellipse{{1.5, 0.4, -0.3, -0.8, 0.5, -0.6}};

TEST(LogisticSurface, ManyRunsGiveTheTruthBack) {
  const LogisticSurface fit = fit_logistic_surface(sampled(ellipse, 15, 10'000, 1));
  // A coefficient is known to some 1/sqrt(runs p (1 - p) places) = 0.005 then.
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(fit.coefficients[k], ellipse.coefficients[k], 0.02) << k;
}

TEST(LogisticSurface, NothingNearItIsMoreLikely) {
  const auto trials = sampled(ellipse, 7, 3, 2);
  const LogisticSurface fit = fit_logistic_surface(trials);
  const double best = penalised(fit, trials);
  for (std::size_t k = 0; k < 6; ++k)
    for (const double step : {-1e-3, 1e-3}) {
      LogisticSurface other = fit;
      other.coefficients[k] += step;
      EXPECT_LT(penalised(other, trials), best) << k << " " << step;
    }
}

TEST(LogisticSurface, HitsThatMissesDoNotMixWithGiveAFiniteSteepSurface) {
  std::vector<Trials> trials;
  for (int i = -5; i <= 5; ++i)
    for (int j = -5; j <= 5; ++j) {
      const double x = 0.6 * i, y = 0.6 * j;
      trials.push_back({x, y, x * x + y * y < 1.5 ? 1.0 : 0.0, 1});
    }
  const LogisticSurface fit = fit_logistic_surface(trials);
  EXPECT_GT(fit.p(0, 0), 0.9);
  EXPECT_LT(fit.p(2, 2), 1e-3);
  // The border lies between the last hits (r = 1.2) and the first misses (1.34).
  EXPECT_GT(fit.p(1.15, 0), 0.5);
  EXPECT_LT(fit.p(1.4, 0), 0.5);
  for (const double c : fit.coefficients) EXPECT_TRUE(std::isfinite(c));
}

TEST(LogisticSurface, TooFewPlacesLeaveOpenWhatTheyDoNotTell) {
  const LogisticSurface nothing = fit_logistic_surface({});
  EXPECT_EQ(nothing.p(3, -2), 0.5);
  const LogisticSurface one = fit_logistic_surface({{0, 0, 3, 3}, {1, 1, 0, 0}});
  EXPECT_GT(one.p(0, 0), 0.5);
  EXPECT_TRUE(std::isfinite(one.p(5, 5)));
}

}  // namespace
}  // namespace eerie::statistics
