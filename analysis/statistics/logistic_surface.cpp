#include "analysis/statistics/logistic_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace eerie::statistics {

namespace {

constexpr int terms = static_cast<int>(LogisticSurface::terms);
using Vector = Eigen::Matrix<double, terms, 1>;
using Matrix = Eigen::Matrix<double, terms, terms>;

Vector features(double x, double y) {
  return (Vector() << 1, x, y, x * x, x * y, y * y).finished();
}

double logistic(double logit) { return 1 / (1 + std::exp(-logit)); }

/// log(1 + exp(logit)) without overflow.
double log_one_plus_exp(double logit) {
  return std::max(logit, 0.0) + std::log1p(std::exp(-std::abs(logit)));
}

/// What one iteration needs at some coefficients.
struct Evaluation {
  double objective = 0;  ///< log likelihood, and half the log determinant of the information
  Matrix information = Matrix::Zero();
  Vector score = Vector::Zero();
};

std::optional<Evaluation> evaluated(const std::vector<Trials>& trials, const Vector& b) {
  Evaluation e;
  // A whiff of a normal prior keeps the information regular where places leave terms open.
  e.information.diagonal().setConstant(1e-8);
  for (const Trials& t : trials) {
    const Vector f = features(t.x, t.y);
    const double p = logistic(f.dot(b));
    e.information += t.runs * p * (1 - p) * f * f.transpose();
  }
  const Eigen::LDLT<Matrix> factors(e.information);
  if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0)) return std::nullopt;
  e.objective = 0.5 * factors.vectorD().array().log().sum() - 0.5e-8 * b.squaredNorm();
  e.score = -1e-8 * b;
  for (const Trials& t : trials) {
    const Vector f = features(t.x, t.y);
    const double logit = f.dot(b), p = logistic(logit);
    const double leverage = t.runs * p * (1 - p) * f.dot(factors.solve(f));
    e.objective += t.hits * logit - t.runs * log_one_plus_exp(logit);
    e.score += (t.hits - t.runs * p + leverage * (0.5 - p)) * f;
  }
  if (!std::isfinite(e.objective)) return std::nullopt;
  return e;
}

}  // namespace

double LogisticSurface::p(double x, double y) const {
  return logistic(Eigen::Map<const Vector>(coefficients.data()).dot(features(x, y)));
}

LogisticSurface fit_logistic_surface(const std::vector<Trials>& all) {
  std::vector<Trials> trials = all;
  std::erase_if(trials, [](const Trials& t) { return !(t.runs > 0); });
  LogisticSurface surface;
  Vector b = Vector::Zero();
  std::optional<Evaluation> now = evaluated(trials, b);
  // Fisher scoring. It converges in some ten steps; long ones are cut, and halved until they gain.
  constexpr int most_steps = 200, most_halvings = 40;
  for (int step = 0; now && step < most_steps; ++step) {
    Vector d = now->information.ldlt().solve(now->score);
    d *= std::min(1.0, 2 / d.cwiseAbs().maxCoeff());
    std::optional<Evaluation> next;
    int halvings = 0;
    while (!(next = evaluated(trials, b + d)) || next->objective < now->objective) {
      d /= 2;
      if (++halvings > most_halvings) break;
    }
    if (halvings > most_halvings) break;  // rounding allows no more
    b += d;
    const double gain = next->objective - now->objective;
    now = next;
    if (gain < 1e-10) break;
  }
  Eigen::Map<Vector>(surface.coefficients.data()) = b;
  return surface;
}

}  // namespace eerie::statistics
