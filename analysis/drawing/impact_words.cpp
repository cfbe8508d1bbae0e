#include "analysis/drawing/impact_words.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "analysis/drawing/grouped.hpp"
#include "solver/scene/field_words.hpp"

namespace eerie::drawing {
using nlohmann::json;

namespace {

/// Fields that a title already has, and those of numerics, for which it has the scheme.
bool is_told(std::string_view field) {
  constexpr std::array groups{"/material/", "/target/", "/impactor/", "/environment/"};
  return field == "/material/drucker_prager/phi_d_deg" ||
         std::ranges::none_of(groups, [&](const char* group) { return field.starts_with(group); });
}

/// "; material.tillotson.A_Pa=267000": what of bodies, matter and surroundings is not as by
/// default, by the names that --set takes; two fields at most.
std::string unlike_default(const Scene& scene) {
  constexpr std::size_t most_fields = 2;
  const json plain = to_json(parse_scene({{"impact",
                                           {{"q", scene.impact.q},
                                            {"v_imp_cm_per_s", scene.impact.v_imp_cm_per_s},
                                            {"theta_imp_deg", scene.impact.theta_imp_deg}}}}))
                         .flatten();
  const json fields = to_json(scene).flatten();
  std::vector<std::string> unlike;
  for (const auto& [field, value] : fields.items())
    if (!is_told(field) && plain.value(field, json()) != value) unlike.push_back(field);
  return unlike.empty() ? "" : "; " + field_words(fields, unlike, most_fields);
}

}  // namespace

Quoted impact_words(const Scene& scene) {
  return marked_up(
      "q = {:g}, φ_d\u00a0= {:g}°, {:g} cm/s, {:g}°; {} particles per target, {}, seed {}{}",
      scene.impact.q, scene.material.drucker_prager.phi_d_deg, scene.impact.v_imp_cm_per_s,
      scene.impact.theta_imp_deg, in_quotes(grouped(scene.numerics.particles_per_target)),
      in_quotes(scene.numerics.scheme), scene.numerics.seed, in_quotes(unlike_default(scene)));
}

}  // namespace eerie::drawing
