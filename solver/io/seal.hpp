#pragma once

#include <string>
#include <string_view>

namespace eerie::io {

/// The last line of a snapshot, behind the end of the HDF5 file, where HDF5 does not look:
/// "eerie-sha256:" and the SHA-256 of all bytes before it. HDF5's own checksums leave out what no
/// reader asked for; this one tells of any bit.
std::string seal(std::string_view bytes);

/// Takes the seal off the end of `bytes`; false where there is none, as in files written before
/// there were seals. Throws h5::Failure where it belongs to other bytes.
bool take_off_seal(std::string& bytes);

}  // namespace eerie::io
