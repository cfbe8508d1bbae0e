#include "campaign/sweeps/document_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/closest_names.hpp"
#include "solver/base/error.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

/// A kind of document: what it is called, and the command that takes it, with {} for its file.
struct KindWords {
  DocumentKind kind;
  const char *name, *command;
};
constexpr KindWords kinds[] = {
    {DocumentKind::scene, "the scene of one impact", "eerie solve {} --out impact"},
    {DocumentKind::sweep, "a sweep of impacts", "eerie run {}"},
    {DocumentKind::convergence_study, "a study of convergence", "eerie converge {}"},
    {DocumentKind::cost_study, "a study of cost and error", "eerie chart {}"},
};

const KindWords* words_of(DocumentKind kind) {
  for (const KindWords& one : kinds)
    if (one.kind == kind) return &one;
  return nullptr;
}

void require_known_below(const json& schema, const json& part, const std::string& path,
                         const std::string& where) {
  if (!part.is_object() || !schema.contains("properties")) return;
  for (const auto& [name, value] : part.items()) {
    const std::string here = path.empty() ? name : path + "." + name;
    if (schema["properties"].contains(name)) {
      require_known_below(schema["properties"][name], value, here, where);
      continue;
    }
    std::vector<std::string> known;
    for (const auto& [other, ignored] : schema["properties"].items()) known.push_back(other);
    const std::vector<std::string> likely = text::likely_names(
        here, here.starts_with("impactor.") ? field_paths() : shared_field_paths());
    throw InputError(fmt::format(
        "{}.{}: there is no such field; {}remove it or use one of {}", where, here,
        likely.empty() ? "" : fmt::format("did you mean {}? Otherwise ", fmt::join(likely, " or ")),
        fmt::join(known, ", ")));
  }
}

}  // namespace

DocumentKind kind_of(const json& document) {
  if (!document.is_object()) return DocumentKind::unknown;
  if (document.contains("grid") || document.contains("points")) return DocumentKind::sweep;
  if (document.contains("knobs")) return DocumentKind::cost_study;
  if (document.contains("cases")) return DocumentKind::convergence_study;
  if (document.contains("name") || document.contains("scene")) return DocumentKind::unknown;
  for (const auto& [group, ignored] : scene_schema().at("properties").items())
    if (document.contains(group)) return DocumentKind::scene;
  return DocumentKind::unknown;
}

void require_kind(DocumentKind wanted, const json& document, const std::string& where) {
  const KindWords* found = words_of(kind_of(document));
  if (found == nullptr || found->kind == wanted) return;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(where, ignored);
  throw InputError(
      fmt::format("{}: is {} and not {}; `{}` takes it", where, found->name, words_of(wanted)->name,
                  fmt::format(fmt::runtime(found->command), is_file ? shell_word(where) : "FILE")));
}

void require_known_fields(const json& scene, const std::string& where) {
  require_known_below(scene_schema(), scene, "", where);
}

}  // namespace eerie::sweeps
