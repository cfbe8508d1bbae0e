#pragma once

#include <string>
#include <string_view>

namespace eerie {

/// SHA-256 in 64 lower-case hex digits. Throws EnvironmentError where OpenSSL has none.
std::string sha256_hex(std::string_view bytes);

}  // namespace eerie
