#include "tests/proof/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/file.hpp"

namespace eerie::proof {
namespace fs = std::filesystem;

namespace {

std::size_t colour_of(const Figure& figure, std::size_t k) {
  const int chosen = figure.curves[k].colour;
  return chosen > 0 ? static_cast<std::size_t>(chosen) : k + 1;
}

drawing::Script script_of(const Figure& figure, const fs::path& path) {
  using drawing::in_quotes, drawing::Literal;
  drawing::Script text = drawing::gnuplot_terminal(path, 360, 230);
  text += drawing::script(
      "set xlabel {}\nset ylabel {}\nset key outside top center horizontal\n"
      "set grid lc rgb '#dddddd'\nset border 3\nset tics nomirror\n{}\n",
      in_quotes(figure.x_label), in_quotes(figure.y_label), figure.extra);
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    text += drawing::script("$c{} << EOD\n", k);
    for (std::size_t i = 0; i < figure.curves[k].x.size(); ++i)
      text += drawing::script("{:.8g} {:.8g}\n", figure.curves[k].x[i], figure.curves[k].y[i]);
    text += "EOD\n";
  }
  text += "plot ";
  for (std::size_t k = 0; k < figure.curves.size(); ++k)
    text += drawing::script("{}$c{} using 1:2 with {} lt {} title {}",
                            k > 0 ? Literal(", ") : Literal(""), k, figure.curves[k].style,
                            colour_of(figure, k), in_quotes(figure.curves[k].title));
  return text + "\n";
}

const char* report_folder() { return std::getenv("EERIE_REPORT"); }

}  // namespace

Record::Record(std::string page, int order, std::string title, std::string text)
    : json_({{"page", std::move(page)},
             {"order", order},
             {"title", std::move(title)},
             {"text", std::move(text)},
             {"blocks", nlohmann::json::array()}}) {}

Record::~Record() {
  if (report_folder() == nullptr) return;
  json_["passed"] = !testing::Test::HasFailure();
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  json_["test"] = fmt::format("{}.{}", test->test_suite_name(), test->name());
  fs::create_directories(report_folder());
  install_text(
      fs::path(report_folder()) / fmt::format("{}.{}.json", test->test_suite_name(), test->name()),
      json_.dump(1));
}

void Record::within(const std::string& what, double value, double lo, double hi,
                    const std::string& reason) {
  EXPECT_GE(value, lo) << what << ": " << reason;
  EXPECT_LE(value, hi) << what << ": " << reason;
  json_["blocks"].push_back({{"kind", "check"},
                             {"what", what},
                             {"value", value},
                             {"lo", lo},
                             {"hi", hi},
                             {"reason", reason},
                             {"passed", value >= lo && value <= hi}});
  testing::Test::RecordProperty("value_" + std::to_string(json_["blocks"].size()),
                                what + " = " + fmt::format("{:.6g}", value));
}

void Record::noted(const std::string& what, double value, const std::string& wish,
                   const std::string& why) {
  json_["blocks"].push_back(
      {{"kind", "note"}, {"what", what}, {"value", value}, {"wish", wish}, {"reason", why}});
}

void Record::figure(const Figure& figure) {
  if (report_folder() == nullptr) return;
  const fs::path path = fs::path(report_folder()) / (figure.name + ".svg");
  fs::create_directories(report_folder());
  drawing::run_gnuplot(script_of(figure, path), path);
  json_["blocks"].push_back(
      {{"kind", "figure"}, {"file", figure.name + ".svg"}, {"caption", figure.caption}});
}

void Record::table(const std::vector<std::string>& head,
                   const std::vector<std::vector<std::string>>& rows) {
  json_["blocks"].push_back({{"kind", "table"}, {"head", head}, {"rows", rows}});
}

void Record::say(const std::string& markdown) {
  json_["blocks"].push_back({{"kind", "text"}, {"text", markdown}});
}

}  // namespace eerie::proof
