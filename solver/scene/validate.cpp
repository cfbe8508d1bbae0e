#include "solver/scene/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "solver/base/error.hpp"

namespace eerie {
using nlohmann::json;

namespace {

/// "must be greater than 0 and at most 1": the allowed values of a leaf, in words.
std::string allowed_values(const json& leaf) {
  if (leaf.contains("enum")) {
    std::vector<std::string> words;
    // Former words are read, for what was written with them, and offered to nobody.
    const json former = leaf.value("former", json::array());
    for (const json& word : leaf["enum"])
      if (std::ranges::find(former, word) == former.end()) words.push_back(word.dump());
    return fmt::format("must be one of {}", fmt::join(words, ", "));
  }
  std::vector<std::string> bounds;
  const auto bound = [&](const char* key, const char* words) {
    if (leaf.contains(key))
      bounds.push_back(fmt::format("{} {:.10g}", words, leaf[key].get<double>()));
  };
  bound("exclusiveMinimum", "greater than");
  bound("minimum", "at least");
  bound("exclusiveMaximum", "less than");
  bound("maximum", "at most");
  const std::string type = leaf.value("type", "value");
  const std::string noun =
      (type == "integer" || type == "object" || type == "array" ? "an " : "a ") + type;
  if (bounds.empty()) return "must be " + noun;
  return fmt::format("must be {} {}", noun, fmt::join(bounds, " and "));
}

std::string field_names(const json& node) {
  std::vector<std::string> names;
  for (const auto& [name, ignored] : node.at("properties").items()) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// "3 entries", "1 to 6 entries" or "at most 6 entries".
std::string length_allowed(const json& schema) {
  const std::size_t least = schema.value("minItems", std::size_t{0}),
                    most = schema.value("maxItems", std::size_t{1000});
  if (least == most) return fmt::format("{} entries", most);
  return least == 0 ? fmt::format("at most {} entries", most)
                    : fmt::format("{} to {} entries", least, most);
}

/// Walks document and schema together; returns the first fault as a sentence, or "".
/// valijson decides *whether* a document is valid; this finds *where*, in the user's terms.
std::string first_fault(const json& schema, const json& document, const std::string& path) {
  const std::string meaning = schema.value("description", "");
  const auto fault = [&](const std::string& rule) {
    std::string text = fmt::format(
        "{} = {}: {}", path, document.dump(-1, ' ', false, json::error_handler_t::replace), rule);
    if (!meaning.empty()) text += fmt::format(" ({})", meaning);
    if (schema.contains("default"))
      text += fmt::format("; for example {}", schema["default"].dump());
    return text;
  };
  const std::string type = schema.value("type", "");
  if (type == "object") {
    if (!document.is_object()) return fault("must be an object {...}");
    for (const json& name : schema.value("required", json::array()))
      if (!document.contains(name.get<std::string>()))
        return fmt::format("{}: the field \"{}\" is missing; add it (known fields: {})", path,
                           name.get<std::string>(), field_names(schema));
    for (const auto& [name, value] : document.items()) {
      const json* child = schema.contains("properties") && schema["properties"].contains(name)
                              ? &schema["properties"][name]
                              : nullptr;
      if (child == nullptr) {
        if (schema.value("additionalProperties", json(true)) != json(false)) continue;
        return fmt::format("{}.{}: there is no such field; remove it or use one of {}", path, name,
                           field_names(schema));
      }
      if (std::string text = first_fault(*child, value, fmt::format("{}.{}", path, name));
          !text.empty())
        return text;
    }
    return "";
  }
  if (type == "array") {
    if (!document.is_array()) return fault("must be an array [...]");
    if (document.size() < schema.value("minItems", std::size_t{0}) ||
        document.size() > schema.value("maxItems", std::size_t{1000}))
      return fault(fmt::format("must have {}", length_allowed(schema)));
    for (std::size_t k = 0; k < document.size(); ++k)
      if (std::string text =
              first_fault(schema["items"], document[k], fmt::format("{}[{}]", path, k));
          !text.empty())
        return text;
    return "";
  }
  if (type == "boolean" && !document.is_boolean()) return fault("must be true or false");
  if (schema.contains("enum")) {
    for (const json& word : schema["enum"])
      if (word == document) return "";
    return fault(allowed_values(schema));
  }
  if (type == "number" || type == "integer") {
    if (!document.is_number() || (type == "integer" && !document.is_number_integer()))
      return fault(allowed_values(schema));
    const double value = document.get<double>();
    const bool inside =
        !(schema.contains("minimum") && value < schema["minimum"].get<double>()) &&
        !(schema.contains("maximum") && value > schema["maximum"].get<double>()) &&
        !(schema.contains("exclusiveMinimum") &&
          value <= schema["exclusiveMinimum"].get<double>()) &&
        !(schema.contains("exclusiveMaximum") && value >= schema["exclusiveMaximum"].get<double>());
    return inside ? "" : fault(allowed_values(schema));
  }
  if (type == "string" && !document.is_string()) return fault(allowed_values(schema));
  return "";
}

/// Schemas live as long as the program, so each is compiled once, under its address.
const valijson::Schema& compiled(const json& schema) {
  static std::mutex mutex;
  static std::map<const json*, valijson::Schema> cache;
  const std::scoped_lock lock(mutex);
  const auto [entry, fresh] = cache.try_emplace(&schema);
  if (fresh)
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema),
                                            entry->second);
  return entry->second;
}

}  // namespace

void require_valid(const json& schema, const json& document, const std::string& where) {
  if (std::string text = first_fault(schema, document, where); !text.empty())
    throw InputError(text);

  valijson::Validator validator;
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter target(document);
  if (validator.validate(compiled(schema), target, &results)) return;
  valijson::ValidationResults::Error error;
  results.popError(error);
  throw InputError(
      fmt::format("{} {}: {}", where, fmt::join(error.context, ""), error.description));
}

const json* schema_at(const json& schema, const std::string& dotted_path) {
  const json* node = &schema;
  std::size_t begin = 0;
  while (begin <= dotted_path.size()) {
    const std::size_t end = std::min(dotted_path.find('.', begin), dotted_path.size());
    const std::string name = dotted_path.substr(begin, end - begin);
    if (!node->contains("properties") || !(*node)["properties"].contains(name)) return nullptr;
    node = &(*node)["properties"][name];
    begin = end + 1;
  }
  return node;
}

json with_defaults(const json& schema, json document) {
  for (const auto& [name, child] : schema.at("properties").items()) {
    if (child.value("type", "") == "object")
      document[name] =
          with_defaults(child, document.contains(name) ? document[name] : json::object());
    else if (!document.contains(name) && child.contains("default"))
      document[name] = child["default"];
    else if (child.value("type", "") == "array" && child["items"].contains("properties"))
      for (json& item : document[name]) item = with_defaults(child["items"], std::move(item));
  }
  return document;
}

}  // namespace eerie
