#pragma once

#include <span>
#include <string>
#include <string_view>

namespace eerie::serve {

/// A file of the page (campaign/serve/page) or of its libraries (libraries.cmake), which the build
/// puts into the program.
struct Asset {
  std::string_view name, text;
};

std::span<const Asset> assets();
/// The file of this name; nothing where there is none.
const Asset* asset_named(std::string_view name);

/// The media type, by the extension of the name.
std::string_view type_of(const Asset& asset);
/// A hash of the text in quotation marks, which browsers compare.
std::string etag_of(const Asset& asset);

}  // namespace eerie::serve
