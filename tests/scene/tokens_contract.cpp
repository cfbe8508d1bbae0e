#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "solver/material/material.hpp"
#include "solver/scene/schemes.hpp"
#include "solver/scene/validate.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/integrator.hpp"

namespace eerie {
namespace {

template <class... T>
std::set<std::string> tokens_of(const std::variant<T...>*) {
  return {T::token...};
}

/// A law that the schema does not know cannot be asked for; a name without a law cannot be kept.
template <class Variant>
void expect_same_names(const char* field) {
  const auto names = schema_at(scene_schema(), field)->at("enum").get<std::set<std::string>>();
  EXPECT_EQ(tokens_of(static_cast<Variant*>(nullptr)), names) << field;
}

TEST(Tokens, OfEveryVariantListAreThoseOfTheSchema) {
  expect_same_names<material::Eos>("material.eos");
  expect_same_names<material::Rheology>("material.rheology");
  expect_same_names<material::Fracture>("material.fracture");
  expect_same_names<sph::KernelChoice>("numerics.kernel");
  expect_same_names<step::Integrator>("numerics.integrator");
}

TEST(Tokens, OfTheSchemesAreThoseOfTheSchemaAndEachMakesAScene) {
  std::set<std::string> tokens;
  for (const Scheme& scheme : schemes) {
    tokens.insert(scheme.token);
    const nlohmann::json wanted = nlohmann::json::parse(scheme.numerics);
    const nlohmann::json scene =
        to_json(parse_scene({{"numerics", {{"scheme", scheme.token}, {"late_sound_speed", 0.5}}},
                             {"end", {{"settled", {{"window_s", 4000}}}}}}))["numerics"];
    for (const auto& [field, value] : wanted.items()) EXPECT_EQ(scene[field], value) << field;
  }
  const nlohmann::json& schema = *schema_at(scene_schema(), "numerics.scheme");
  EXPECT_EQ(tokens, schema.at("enum").get<std::set<std::string>>());
  for (const nlohmann::json& former : schema.at("former"))
    EXPECT_TRUE(tokens.contains(former.get<std::string>())) << former;
}

}  // namespace
}  // namespace eerie
