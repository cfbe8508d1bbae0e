#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace eerie::test {

/// A sweep file that must be refused.
struct MalformedSweep {
  const char* name;      ///< of the case, a word
  std::string text;      ///< of the file
  std::string expected;  ///< what the message must say
};

/// A good sweep with something in place of its scene or its grid.
inline std::string with_scene(const std::string& scene) {
  return R"({"name": "s", "scene": )" + scene + R"(, "grid": {"v_imp_cm_per_s": [20]}})";
}
inline std::string with_grid(const std::string& grid) {
  return R"({"name": "s", "grid": )" + grid + "}";
}
inline std::string with_v(const std::string& axis) {
  return with_grid(R"({"v_imp_cm_per_s": )" + axis + "}");
}
inline std::string with_points(const std::string& points) {
  return R"({"name": "s", "points": )" + points + "}";
}
inline std::string with_name(const std::string& name) {
  return R"({"name": )" + name + R"(, "grid": {"q": [1]}})";
}

/// How a failing case shows itself.
inline std::ostream& operator<<(std::ostream& out, const MalformedSweep& sweep) {
  return out << sweep.text;
}

inline const std::vector<MalformedSweep>& malformed_sweeps() {
  static const std::vector<MalformedSweep> cases = {
      // not JSON: the place and what was expected
      {"Empty", "", "line 1, column 1"},
      {"Blank", " \n\n ", "line 3"},
      {"NotJson", "hello", "line 1, column 1"},
      {"Unclosed", "{\"name\": \"s\",\n \"grid\": {", "line 2"},
      {"TrailingComma", "{\"name\": \"s\",\n\"grid\": {\"q\": [1,]}}", "line 2, column 18"},
      {"CommaAfterField", "{\"name\": \"s\",}", "expected string literal"},
      {"MissingColon", "{\"name\" \"s\"}", "expected ':'"},
      {"MissingComma", "{\"name\": \"s\" \"grid\": {}}", "expected"},
      {"SingleQuotes", "{'name': 's'}", "line 1, column 2"},
      {"Comment", "{\"name\": \"s\", // sweep\n\"grid\": {}}", "line 1, column 15"},
      {"TwoDocuments", with_v("[20]") + " {}", "expected end of input"},
      {"NotANumber", with_v("[NaN]"), "not JSON"},
      {"InfiniteNumber", with_v("[1e999]"), "not JSON"},
      {"PlusSign", with_v("[+20]"), "not JSON"},
      {"LeadingZero", with_v("[020]"), "not JSON"},
      {"HexNumber", with_v("[0x14]"), "not JSON"},
      {"NakedWord", with_v("[twenty]"), "not JSON"},
      {"BadEscape", with_name("\"a\\q\""), "not JSON"},
      {"NewlineInString", with_name("\"a\nb\""), "not JSON"},
      {"BadUtf8", with_name("\"\xff\xfe\""), "not JSON"},
      {"NulByte", std::string("{\"name\": \0\"s\"}", 14), "not JSON"},
      {"DeepNesting", std::string(200, '[') + std::string(200, ']'), "nested deeper than 32"},
      {"KeyTwice", R"({"name": "a", "name": "b", "grid": {"q": [1]}})", "\"name\" stands twice"},
      {"AxisTwice", with_grid(R"({"q": [1], "q": [0.5]})"), "\"q\" stands twice"},
      {"SceneKeyTwice", with_scene(R"({"impact": {"q": 1, "q": 0.5}})"), "\"q\" stands twice"},
      // not a sweep
      {"Null", "null", "must be an object"},
      {"Number", "3", "must be an object"},
      {"String", "\"first-light\"", "must be an object"},
      {"Array", "[]", "must be an object"},
      {"EmptyObject", "{}", "\"name\" is missing"},
      {"NoName", R"({"grid": {"q": [1]}})", "\"name\" is missing"},
      {"NoGrid", R"({"name": "s"})", "\"grid\" is missing"},
      {"UnknownField", R"({"name": "s", "grid": {"q": [1]}, "jobs": 3})",
       "sweep.jobs: there is no such field"},
      {"MisspeltGrid", R"({"name": "s", "gird": {"q": [1]}})",
       "sweep.gird: there is no such field"},
      {"NameNumber", with_name("7"), "must be a string"},
      {"NameNull", with_name("null"), "must be a string"},
      {"NameEmpty", with_name("\"\""), "1 to 64 letters"},
      {"NameWithSlash", with_name("\"a/b\""), "1 to 64 letters"},
      {"NameUpwards", with_name("\"..\""), "1 to 64 letters"},
      {"NameWithSpace", with_name("\"a b\""), "1 to 64 letters"},
      {"NameHidden", with_name("\".a\""), "1 to 64 letters"},
      {"NameLikeAnOption", with_name("\"-a\""), "1 to 64 letters"},
      {"NameTooLong", with_name("\"" + std::string(65, 'a') + "\""), "1 to 64 letters"},
      {"NameNotAscii", with_name("\"\xc3\xa4\""), "1 to 64 letters"},
      {"DescriptionNumber", R"({"name": "s", "description": 1, "grid": {"q": [1]}})",
       "must be a string"},
      // the scene
      {"SceneNull", with_scene("null"), "must be an object"},
      {"SceneArray", with_scene("[]"), "must be an object"},
      {"SceneUnknownGroup", with_scene(R"({"impakt": {}})"),
       "scene.impakt: there is no such field"},
      {"SceneUnknownField", with_scene(R"({"impact": {"speed": 20}})"),
       "scene.impact.speed: there is no such field"},
      {"SceneGroupNumber", with_scene(R"({"impact": 3})"), "must be an object"},
      {"QZero", with_scene(R"({"impact": {"q": 0}})"), "greater than 0 and at most 1"},
      {"QAboveOne", with_scene(R"({"impact": {"q": 1.5}})"), "scene.impact.q = 1.5"},
      {"QString", with_scene(R"({"impact": {"q": "1"}})"), "must be a number"},
      {"QNull", with_scene(R"({"impact": {"q": null}})"), "must be a number"},
      {"QTrue", with_scene(R"({"impact": {"q": true}})"), "must be a number"},
      {"QList", with_scene(R"({"impact": {"q": [1]}})"), "must be a number"},
      {"ThetaInScene", with_scene(R"({"impact": {"theta_imp_deg": 90}})"),
       "at least 0 and at most 89"},
      {"SeparationTooSmall", with_scene(R"({"impact": {"separation": 1}})"), "at least 1.3"},
      {"RadiusNegative", with_scene(R"({"target": {"radius_m": -50}})"),
       "scene.target.radius_m = -50"},
      {"RadiusHuge", with_scene(R"({"target": {"radius_m": 1e9}})"), "at most 1000000"},
      {"DensityTooLow", with_scene(R"({"material": {"rho0_kg_per_m3": 1}})"), "at least 100"},
      {"UnknownEos", with_scene(R"({"material": {"eos": "aneos"}})"),
       "must be one of \"tillotson\""},
      {"EosNumber", with_scene(R"({"material": {"eos": 1}})"), "must be one of"},
      {"UnknownRheology", with_scene(R"({"material": {"rheology": "mohr-coulomb"}})"),
       "drucker-prager"},
      {"BulkModulusZero", with_scene(R"({"material": {"tillotson": {"A_Pa": 0}}})"),
       "greater than 0"},
      {"FrictionAngle", with_scene(R"({"material": {"drucker_prager": {"phi_d_deg": 90}}})"),
       "at most 80"},
      {"CohesionNegative", with_scene(R"({"material": {"drucker_prager": {"cohesion_Pa": -1}}})"),
       "at least 0"},
      {"FewParticles", with_scene(R"({"numerics": {"particles_per_target": 99}})"), "at least 100"},
      {"HalfAParticle", with_scene(R"({"numerics": {"particles_per_target": 1000.5}})"),
       "must be an integer"},
      {"ManyParticles", with_scene(R"({"numerics": {"particles_per_target": 100000000}})"),
       "at most 10000000"},
      {"SeedNegative", with_scene(R"({"numerics": {"seed": -1}})"), "at least 0"},
      {"SeedTooLarge", with_scene(R"({"numerics": {"seed": 4294967296}})"), "at most 4294967295"},
      {"UnknownKernel", with_scene(R"({"numerics": {"kernel": "gauss"}})"), "cubic-spline"},
      {"UnknownPacking", with_scene(R"({"numerics": {"packing": "hcp"}})"), "glass"},
      {"UnknownPrecision", with_scene(R"({"numerics": {"precision": "half"}})"), "float"},
      {"CflZero", with_scene(R"({"numerics": {"cfl": 0}})"), "greater than 0"},
      {"CflTooLarge", with_scene(R"({"numerics": {"cfl": 2}})"), "at most 1.5"},
      {"GravityNever", with_scene(R"({"numerics": {"gravity_interval": 0}})"), "at least 1"},
      {"EndTimeZero", with_scene(R"({"end": {"time_s": 0}})"), "greater than 0"},
      {"EndTimeNegative", with_scene(R"({"end": {"time_s": -1}})"), "scene.end.time_s = -1"},
      {"HistoryNever", with_scene(R"({"output": {"history_interval_s": 0}})"), "greater than 0"},
      {"SmallImpactor", with_scene(R"({"impact": {"q": 0.01}})"), "would have 50 particles"},
      {"FieldInSceneAndGrid", with_scene(R"({"impact": {"v_imp_cm_per_s": 20}})"),
       "remove one of them"},
      // the grid
      {"GridNull", with_grid("null"), "must be an object"},
      {"GridArray", with_grid("[]"), "must be an object"},
      {"GridEmpty", with_grid("{}"), "at least one axis"},
      {"AxisUnknown", with_grid(R"({"v_imp": [20]})"), "the closest are impact.v_imp_cm_per_s"},
      {"AxisMisspelt", with_grid(R"({"impact.thetaimp_deg": [20]})"), "impact.theta_imp_deg"},
      {"AxisNoName", with_grid(R"({"": [20]})"), "no field \"\""},
      {"AxisDots", with_grid(R"({"..": [20]})"), "no field"},
      {"AxisGroup", with_grid(R"({"impact": [20]})"), "is a group of fields"},
      {"AxisOfUnknownWord", with_grid(R"({"numerics.kernel": ["wendland-c2", "gauss"]})"),
       "numerics.kernel[1] = \"gauss\": must be one of"},
      {"AxisOfAWordTwice", with_grid(R"({"numerics.kernel": ["wendland-c2", "wendland-c2"]})"),
       "stands twice"},
      {"AxisOfWordsAsNumbers", with_grid(R"({"numerics.kernel": [1]})"), "must be one of"},
      {"AxisOfFlagsAsWords", with_grid(R"({"numerics.rigid_flight": ["true"]})"),
       "must be true or false"},
      {"AxisOfWordsAsRange", with_grid(R"({"numerics.kernel": {"from": 1, "to": 2, "step": 1}})"),
       "must be a list of values; for example [\"cubic-spline\"]"},
      {"AxisOfALists", with_grid(R"({"environment.walls": [[]]})"), "must be a field of one value"},
      {"AxisOfOutput", with_grid(R"({"output.history_interval_s": [100, 200]})"),
       "put it into \"scene\""},
      {"AxisTwoNames", with_grid(R"({"q": [1], "impact.q": [0.5]})"),
       "two axes name the field impact.q"},
      {"AxisNull", with_v("null"), "must be a list of numbers"},
      {"AxisNumber", with_v("20"), "must be a list of numbers"},
      {"AxisString", with_v("\"12:36:3\""), "must be a list of numbers"},
      {"AxisEmptyList", with_v("[]"), "at least one number"},
      {"AxisListOfStrings", with_v("[\"20\"]"), "v_imp_cm_per_s[0] = \"20\""},
      {"AxisListOfLists", with_v("[[20]]"), "must be a number"},
      {"AxisListWithNull", with_v("[20, null]"), "v_imp_cm_per_s[1] = null"},
      {"AxisValueTwice", with_v("[20, 21, 20]"), "v_imp_cm_per_s[2] = 20: stands twice"},
      {"AxisSameNumber", with_v("[20, 20.0]"), "stands twice"},
      {"AxisSignedZero", with_grid(R"({"theta_imp_deg": [0, -0.0]})"), "stands twice"},
      {"AxisValueNegative", with_v("[20, -5]"), "v_imp_cm_per_s[1] = -5"},
      {"AxisValueZero", with_v("[0]"), "greater than 0"},
      {"AxisValueTooLarge", with_v("[20000]"), "at most 10000"},
      {"AxisHalfASeed", with_grid(R"({"numerics.seed": [1.5]})"), "must be an integer"},
      {"AxisThetaTooLarge", with_grid(R"({"theta_imp_deg": {"from": 80, "to": 90, "step": 5}})"),
       "at most 89"},
      {"AxisSmallImpactor", with_grid(R"({"q": [1, 0.001]})"), "would have 5 particles"},
      {"RangeEmpty", with_v("{}"), "\"from\" is missing"},
      {"RangeNoTo", with_v(R"({"from": 12, "step": 3})"), "\"to\" is missing"},
      {"RangeNoStep", with_v(R"({"from": 12, "to": 36})"), "\"step\" is missing"},
      {"RangeUnknownField", with_v(R"({"from": 12, "to": 36, "by": 3})"), "has from, to and step"},
      {"RangeString", with_v(R"({"from": "12", "to": 36, "step": 3})"), "from = \"12\""},
      {"RangeNull", with_v(R"({"from": 12, "to": null, "step": 3})"), "to = null"},
      {"RangeStepZero", with_v(R"({"from": 12, "to": 36, "step": 0})"), "greater than 0"},
      {"RangeStepNegative", with_v(R"({"from": 36, "to": 12, "step": -3})"), "step = -3"},
      {"RangeBackwards", with_v(R"({"from": 36, "to": 12, "step": 3})"), "at least from = 36"},
      {"RangeOffTheGrid", with_v(R"({"from": 12, "to": 37, "step": 3})"),
       "nearest that fit are 36 and 39"},
      {"RangeJustOff", with_v(R"({"from": 1, "to": 1.95, "step": 0.1})"), "1.9 and 2"},
      {"RangeStepTooSmall", with_v(R"({"from": 12, "to": 36, "step": 1e-9})"),
       "more than 200000 values"},
      {"RangeStepTiny", with_v(R"({"from": 12, "to": 36, "step": 1e-300})"),
       "more than 200000 values"},
      // points
      {"PointsNull", with_points("null"), "must be an array"},
      {"PointsEmpty", with_points("[]"), "\"grid\" is missing"},
      {"PointsOfNumbers", with_points("[20]"), "points[0]: must be an object"},
      {"PointEmpty", with_points(R"([{"q": 1}, {}])"), "points[1]: must be an object"},
      {"PointList", with_points(R"([{"q": [1]}])"), "points[0].q = [1]: must be a number"},
      {"PointUnknown", with_points(R"([{"v_imp": 20}])"), "the closest are impact.v_imp_cm_per_s"},
      {"PointRange", with_points(R"([{"q": 1}, {"q": 2}])"), "points[1].q"},
      {"PointTwoNames", with_points(R"([{"q": 1, "impact.q": 0.5}])"), "a second time"},
      {"PointsUnlike", with_points(R"([{"q": 1}, {"v_imp_cm_per_s": 20}])"), "the same fields"},
      {"PointTwice", with_points(R"([{"q": 1}, {"q": 0.5}, {"q": 1.0}])"),
       "points[2]: is the same as"},
      {"PointAndAxis", R"({"name": "s", "points": [{"q": 1}], "grid": {"q": [1]}})",
       "in the points and an axis"},
      {"PointAndScene", R"({"name": "s", "points": [{"q": 1}], "scene": {"impact": {"q": 1}}})",
       "in the points too"},
      {"PointSmallImpactor", with_points(R"([{"q": 1}, {"q": 0.001}])"), "would have 5 particles"},
      {"TooManyJobs",
       with_grid(
           R"({"v_imp_cm_per_s": {"from": 1, "to": 1000, "step": 1}, "numerics.seed": {"from": 0, "to": 1000, "step": 1}})"),
       "1001000 jobs are more than the 200000"},
  };
  return cases;
}

}  // namespace eerie::test
