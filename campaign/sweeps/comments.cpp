#include "campaign/sweeps/comments.hpp"

#include <nlohmann/json.hpp>

namespace eerie::sweeps {
using nlohmann::json;

namespace {

void remove_comments(json& node) {
  if (node.is_object())
    for (auto member = node.begin(); member != node.end();)
      member = member.key().starts_with("//") && member->is_string() ? node.erase(member)
                                                                     : std::next(member);
  if (node.is_structured())
    for (json& child : node) remove_comments(child);
}

}  // namespace

json without_comments(json document) {
  if (document.is_object() && document.contains("$schema") && document["$schema"].is_string())
    document.erase("$schema");
  remove_comments(document);
  return document;
}

}  // namespace eerie::sweeps
