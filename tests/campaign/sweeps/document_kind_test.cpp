#include "campaign/sweeps/document_kind.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::sweeps {
namespace {
using nlohmann::json;
using testing::HasSubstr;
using testing::ThrowsMessage;

const json scene = {{"impact", {{"q", 1}}}};
const json sweep = {{"name", "s"}, {"grid", {{"q", {1}}}}};

TEST(DocumentKind, IsThatOfEveryFileThatIsShipped) {
  for (const auto& [folder, kinds] :
       {std::pair("sweeps", std::set{DocumentKind::sweep}),
        std::pair("sweeps/studies",
                  std::set{DocumentKind::convergence_study, DocumentKind::cost_study})}) {
    std::set<DocumentKind> found;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / folder))
      if (entry.path().extension() == ".json") found.insert(kind_of(text::load_json(entry.path())));
    EXPECT_EQ(found, kinds) << folder;
  }
  EXPECT_EQ(kind_of(scene), DocumentKind::scene);
  for (const json& other : {json::object(), json::array(), json(3), json{{"name", "s"}}})
    EXPECT_EQ(kind_of(other), DocumentKind::unknown) << other;
}

TEST(DocumentKind, OfAnotherCommandIsRefusedWithThatCommand) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "my scene.json";
  install_text(file, scene.dump());
  EXPECT_THAT([&] { load_sweep(file); },
              ThrowsMessage<InputError>(HasSubstr("is the scene of one impact and not a sweep of "
                                                  "impacts; `eerie solve '" +
                                                  file + "' --out impact` takes it")));
  install_text(file, sweep.dump());
  EXPECT_THAT([&] { load_scene(file, {}); },
              ThrowsMessage<InputError>(HasSubstr("`eerie run '" + file + "'` takes it")));
  EXPECT_THAT(
      [] {
        parse_sweep({{"name", "s"}, {"cases", json::array()}}, {}, "standard input");
      },
      ThrowsMessage<InputError>(HasSubstr("`eerie converge FILE` takes it")));
}

TEST(KnownFields, AreNamedWhereAnotherWordIsUsedForThem) {
  const auto refusal = [](const json& given) {
    return [given] { require_known_fields(given, "s.json: scene"); };
  };
  EXPECT_THAT(refusal({{"numerics", {{"particles", 1000}}}}),
              ThrowsMessage<InputError>(testing::StartsWith(
                  "s.json: scene.numerics.particles: there is no such field; did you mean "
                  "numerics.particles_per_target? Otherwise remove it or use one of ")));
  EXPECT_THAT(refusal({{"impact", {{"velocity", 20}}}}),
              ThrowsMessage<InputError>(HasSubstr("did you mean impact.v_imp_cm_per_s?")));
  EXPECT_THAT(refusal({{"v_imp_cm_per_s", 20}}),
              ThrowsMessage<InputError>(HasSubstr("did you mean impact.v_imp_cm_per_s?")));
  EXPECT_THAT(
      refusal({{"friction", 40}}),
      ThrowsMessage<InputError>(HasSubstr("did you mean material.drucker_prager.phi_d_deg?")));
  EXPECT_NO_THROW(refusal(scene)());
}

}  // namespace
}  // namespace eerie::sweeps
