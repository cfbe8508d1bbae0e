#pragma once

namespace eerie::statistics {

/// The probability that a number of Student's t distribution with `freedom` (> 0) degrees of
/// freedom lies below t. It uses Simpson's rule over the angle in t = sqrt(freedom) tan(angle); the
/// error is below 1e-6 for freedom >= 1.
double student_cdf(double t, double freedom);

}  // namespace eerie::statistics
