#include "campaign/sweeps/first_files.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "campaign/sweeps/comments.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::sweeps {
namespace {
using nlohmann::json;

json document(const std::string& name) {
  for (const FirstFile& file : first_files(".").files)
    if (file.name == name) return json::parse(file.content);
  throw InputError("no file " + name);
}

/// Whether the schema takes a document, as an editor would say.
bool takes(const json& schema, const json& given) {
  valijson::Schema compiled;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema),
                                          compiled);
  const valijson::adapters::NlohmannJsonAdapter target(given);
  return valijson::Validator().validate(compiled, target, nullptr);
}

TEST(FirstFiles, AreASweepAndASceneThatTheProgramTakes) {
  const test::TemporaryFolder folder;
  for (const FirstFile& file : first_files(".").files)
    install_text(folder.path() / file.name, file.content);
  const Sweep sweep = load_sweep(folder / "impacts.json");
  EXPECT_EQ(point_count(sweep), 9u);
  EXPECT_EQ(expand(sweep).front().target.radius_m, 50);
  EXPECT_EQ(load_scene(folder / "scene.json", {}).scene.numerics.particles_per_target, 1000);
}

TEST(FirstFiles, AreTakenByTheSchemasThatTheyName) {
  EXPECT_EQ(document("impacts.json").at("$schema"), "./sweep.schema.json");
  EXPECT_EQ(document("scene.json").at("$schema"), "./scene.schema.json");
  const json sweep_schema = document("sweep.schema.json"),
             scene_schema = document("scene.schema.json");
  EXPECT_TRUE(takes(sweep_schema, document("impacts.json")));
  EXPECT_TRUE(takes(scene_schema, document("scene.json")));
  json wrong = document("impacts.json");
  wrong["scene"]["numerics"]["particles"] = 3;
  EXPECT_FALSE(takes(sweep_schema, wrong));
  wrong = document("impacts.json");
  wrong["grid"]["velocity"] = {3};
  EXPECT_FALSE(takes(sweep_schema, wrong));
  wrong = document("impacts.json");
  wrong["grid"]["theta_imp_deg"] = {90};
  EXPECT_FALSE(takes(sweep_schema, wrong));
  json words = document("impacts.json");
  words["grid"]["numerics.kernel"] = {"wendland-c2"};
  EXPECT_TRUE(takes(sweep_schema, words));
  words["grid"]["numerics.kernel"] = {"gauss"};
  EXPECT_FALSE(takes(sweep_schema, words));
}

TEST(FirstFiles, SayCommandsThatAShellTakesWhateverTheFolderIsCalled) {
  const FirstFiles first = first_files("my impacts");
  EXPECT_EQ(first.next.front().command, "eerie expand 'my impacts/impacts.json'");
  EXPECT_EQ(first_files(".").next.front().command, "eerie expand impacts.json");
}

TEST(Comments, AreLeftOutWhereverTheyStandAndNothingElseIs) {
  const json given = {{"$schema", "./s.json"},
                      {"//", "why"},
                      {"name", "s"},
                      {"scene", {{"// q", "a ratio"}, {"impact", {{"q", 1}, {"//", "x"}}}}},
                      {"points", {{{"q", 1}, {"//", "first"}}}}};
  const json wanted = {
      {"name", "s"}, {"scene", {{"impact", {{"q", 1}}}}}, {"points", {{{"q", 1}}}}};
  EXPECT_EQ(without_comments(given), wanted);
}

TEST(Comments, MayNotBeWhatARunMightBeTakenToDependOn) {
  for (const char* text : {R"({"name": "s", "grid": {"q": [1]}, "// seed": 3})",
                           R"({"name": "s", "grid": {"q": [1], "//": [1, 2]}})",
                           R"({"name": "s", "grid": {"q": [1]}, "$schema": {}})",
                           R"({"name": "s", "grid": {"q": [1]}, "scene": {"$schema": "x"}})",
                           R"({"name": "s", "grid": {"q": [1]}, "scene": {"//": {}}})"})
    EXPECT_THROW(parse_sweep(json::parse(text), {}, "s.json"), InputError) << text;
}

}  // namespace
}  // namespace eerie::sweeps
