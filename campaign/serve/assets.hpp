#pragma once

#include <span>
#include <string>
#include <string_view>

namespace eerie::serve {

/// A file of the page (campaign/serve/page), in the program since it was built.
struct Asset {
  std::string_view name, text;
};

std::span<const Asset> assets();
/// Nothing where there is no file of the name.
const Asset* asset_named(std::string_view name);

/// By the extension of its name.
std::string_view type_of(const Asset& asset);
/// A hash of its text in quotation marks: what browsers compare.
std::string etag_of(const Asset& asset);

}  // namespace eerie::serve
