#include "analysis/diagrams/map_quantity.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/maps/map.hpp"

namespace eerie::cli {
namespace {

struct MapArguments {
  std::filesystem::path database;
  maps::NamedMaps request;
  std::vector<std::string> quantities;
};

Answer map(MapArguments& a) {
  maps::require_map_files(a.request.files, "-o");
  if (!a.quantities.empty()) a.request.quantities.clear();
  for (const std::string& token : a.quantities)
    a.request.quantities.push_back(diagrams::quantity_named(token));
  const db::Connection connection(a.database, db::Access::read);
  Answer answer;
  answer.data = {{"pictures", Value::array()}, {"tables", Value::array()}};
  const auto files = maps::draw_named_maps(connection, a.request);
  for (const auto& file : files)
    answer.data[file.extension() == ".csv" ? "tables" : "pictures"].push_back(file.string());
  answer.add_files(files);
  return answer;
}

}  // namespace

Action add_map(CLI::App& app) {
  auto a = std::make_shared<MapArguments>();
  add_database(app, a->database);
  std::string known;
  for (const diagrams::QuantityName& row : diagrams::quantity_names)
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.token);
  app.add_option("--quantity", a->quantities,
                 fmt::format("what to show: {}; several, with commas, make a panel each "
                             "(default: b/a)",
                             known))
      ->delimiter(',');
  add_map_filter(app, a->request.filter);
  app.add_option("-o,--output", a->request.files,
                 "picture: .png, .svg or .pdf, with its numbers beside it as .csv; or .csv alone; "
                 "may be repeated")
      ->required();
  add_formats(app);
  return [a](Output&) { return map(*a); };
}

}  // namespace eerie::cli
