#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace eerie {
namespace {

nlohmann::json said_by(const char* program) {
  std::FILE* pipe = ::popen(program, "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe))
    text.append(part.data(), n);
  EXPECT_EQ(::pclose(pipe), 0) << program;
  return nlohmann::json::parse(text);
}

TEST(GenericVariant, SaysWhatItIsAndGivesTheSamePhysics) {
  const auto native = said_by(EERIE_VARIANT_NATIVE), generic = said_by(EERIE_VARIANT_GENERIC);
  EXPECT_THAT(generic["variant"].get<std::string>(), testing::HasSubstr("generic x86-64"));
  EXPECT_FALSE(native["variant"].get<std::string>().empty());
  const double h = native["h_m"];
  ASSERT_EQ(native["early_x_m"].size(), generic["early_x_m"].size());
  double farthest = 0;
  for (std::size_t k = 0; k < native["early_x_m"].size(); ++k)
    farthest = std::max(farthest, std::abs(native["early_x_m"][k].get<double>() -
                                           generic["early_x_m"][k].get<double>()));
  EXPECT_LT(farthest, 1e-5 * h);  // rounding of single-precision sums over 20 steps
  // Later an impact amplifies the last place, but less than a packing's luck.
  EXPECT_NEAR(generic["mass_over_total"], native["mass_over_total"], 0.02);
  EXPECT_NEAR(generic["a_m"].get<double>() / native["a_m"].get<double>(), 1, 0.03);
  EXPECT_NEAR(generic["b_over_a"], native["b_over_a"], 0.03);
}

}  // namespace
}  // namespace eerie
