#pragma once

#include <string>
#include <string_view>

namespace eerie {

/// The SHA-256 of a text, in 64 lower-case hexadecimal digits. Throws EnvironmentError where
/// OpenSSL offers no SHA-256.
std::string sha256_hex(std::string_view bytes);

}  // namespace eerie
