#pragma once

namespace eerie::statistics {

/// Part of Student's t distribution with `freedom` (> 0) degrees of freedom below t. By Simpson's
/// rule over the angle of t = sqrt(freedom) tan(angle); error below 1e-6 for freedom >= 1.
double student_cdf(double t, double freedom);

}  // namespace eerie::statistics
