#include "campaign/serve/assets.hpp"

#include <algorithm>
#include <functional>
#include <string>

namespace eerie::serve {

const Asset* asset_named(std::string_view name) {
  const auto found = std::ranges::find(assets(), name, &Asset::name);
  return found == assets().end() ? nullptr : &*found;
}

std::string_view type_of(const Asset& asset) {
  if (asset.name.ends_with(".html")) return "text/html; charset=utf-8";
  if (asset.name.ends_with(".css")) return "text/css; charset=utf-8";
  if (asset.name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (asset.name.ends_with(".txt")) return "text/plain; charset=utf-8";
  return "image/svg+xml";
}

std::string etag_of(const Asset& asset) {
  return '"' + std::to_string(std::hash<std::string_view>{}(asset.text)) + '"';
}

}  // namespace eerie::serve
