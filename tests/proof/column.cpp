#include "tests/proof/column.hpp"

#include <algorithm>
#include <cmath>

#include "tests/proof/cliff.hpp"

namespace eerie::proof {

RunOut run_out(double aspect, int across) {
  const Surface end =
      collapse({.aspect = aspect, .phi_d_deg = 27.2, .across = across}, {6}).front();
  return {aspect, reach_at_height(end, 2. / across) - 1, end.front - 1, end.kinetic_energy};
}

double lube(double aspect) { return std::min(1.2 * aspect, 1.9 * std::cbrt(aspect * aspect)); }

double lajeunesse(double aspect) {
  return std::min(1.8 * aspect, 2.3 * std::cbrt(aspect * aspect));
}

}  // namespace eerie::proof
