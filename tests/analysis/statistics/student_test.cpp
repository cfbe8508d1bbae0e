#include "analysis/statistics/student.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::statistics {
namespace {

TEST(Student, HasTheTabledQuantiles) {
  EXPECT_NEAR(student_cdf(2.015048, 5), 0.95, 1e-6);
  EXPECT_NEAR(student_cdf(2.228139, 10), 0.975, 1e-6);
  EXPECT_NEAR(student_cdf(-3.365, 5), 0.01, 1e-5);
  EXPECT_NEAR(student_cdf(1.644854, 1e6), 0.95, 1e-5);  // the normal distribution
}

TEST(Student, IsCauchysWithOneDegreeOfFreedom) {
  for (const double t : {-30.0, -1.0, 0.0, 0.2, 5.0, 1000.0})
    EXPECT_NEAR(student_cdf(t, 1), 0.5 + std::atan(t) / pi, 1e-9) << t;
}

TEST(Student, HasItsClosedFormWithTwoDegreesOfFreedom) {
  for (const double t : {-7.0, -0.5, 0.1, 3.0})
    EXPECT_NEAR(student_cdf(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)), 1e-9) << t;
}

}  // namespace
}  // namespace eerie::statistics
