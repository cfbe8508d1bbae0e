#include "solver/io/seal.hpp"

#include "solver/base/sha256.hpp"
#include "solver/io/hdf5.hpp"

namespace eerie::io {

namespace {
constexpr std::string_view mark = "eerie-sha256:";
constexpr std::size_t length = mark.size() + 64 + 1;
}  // namespace

std::string seal(std::string_view bytes) { return std::string(mark) + sha256_hex(bytes) + '\n'; }

bool take_off_seal(std::string& bytes) {
  if (bytes.size() < length) return false;
  const std::string_view content = std::string_view(bytes).substr(0, bytes.size() - length);
  const std::string_view line = std::string_view(bytes).substr(content.size());
  if (!line.starts_with(mark)) return false;
  if (line != seal(content))
    throw h5::Failure("it is damaged: its bytes have another SHA-256 than when it was written");
  bytes.resize(content.size());
  return true;
}

}  // namespace eerie::io
