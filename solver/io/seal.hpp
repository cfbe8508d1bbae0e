#pragma once

#include <string>
#include <string_view>

namespace eerie::io {

/// The seal is the last line of a snapshot, behind the end of the HDF5 file, where HDF5 does not
/// look. It holds "eerie-sha256:" and the SHA-256 of all bytes before it. HDF5 checks only the
/// parts that a reader asks for; the seal covers every bit.
std::string seal(std::string_view bytes);

/// Removes the seal from the end of `bytes`. Returns false where there is none, as in files that
/// are older than seals. Throws h5::Failure where the seal belongs to other bytes.
bool take_off_seal(std::string& bytes);

}  // namespace eerie::io
