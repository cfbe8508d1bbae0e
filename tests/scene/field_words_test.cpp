#include "solver/scene/field_words.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace eerie {
namespace {

TEST(FieldWords, NamesAFieldAsSetDoes) { EXPECT_EQ(dotted("/impact/q"), "impact.q"); }

TEST(FieldWords, TellNumbersShortTextsPlainlyAndWhatIsMissingAsOff) {
  const nlohmann::json scene = {
      {"/end/time_s", 30000.0}, {"/numerics/scheme", "dual"}, {"/numerics/rigid_flight", true}};
  EXPECT_EQ(field_words(scene, {"/numerics/scheme", "/end/time_s"}, 2),
            "numerics.scheme=dual, end.time_s=30000");
  EXPECT_EQ(field_words(scene, {"/numerics/rigid_flight", "/numerics/flow_mach"}, 2),
            "numerics.rigid_flight=true, numerics.flow_mach=off");
}

TEST(FieldWords, CountTheFieldsThatAreTooMany) {
  const nlohmann::json scene = {{"/a", 1}, {"/b", 2}, {"/c", 3}};
  EXPECT_EQ(field_words(scene, {"/a", "/b", "/c"}, 1), "a=1 and 2 more");
  EXPECT_EQ(field_words(scene, {}, 1), "");
}

}  // namespace
}  // namespace eerie
