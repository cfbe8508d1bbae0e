#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "solver/base/tensor.hpp"
#include "solver/base/vec3.hpp"

/// The part of HDF5's C interface that snapshots need, with handles that close themselves. Files
/// are built and read in memory. Only plain reads and writes touch the disk, since their errors
/// have names.
namespace eerie::io::h5 {

/// Thrown where an HDF5 call fails, or where a file lacks what the caller asks for. Callers turn it
/// into InputError or EnvironmentError.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns `id` where it is valid. Throws Failure "<doing>: <HDF5's innermost reason>" otherwise.
hid_t checked(hid_t id, const std::string& doing);
/// Checks the status that a call returns, in the same way.
void require(herr_t status, const std::string& doing);

/// While it lives, HDF5 prints no error stack in this thread. It goes before any other use of HDF5.
class Silence {
 public:
  Silence() {
    // After a damaged file the library's clean-up at exit does not end and complains on stderr.
    // Files in memory need no clean-up.
    [[maybe_unused]] static const herr_t no_clean_up_at_exit = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Owns one HDF5 identifier and closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& o) noexcept : id_(std::exchange(o.id_, H5I_INVALID_HID)), close_(o.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

 private:
  hid_t id_;
  Close close_;
};

/// The layout of one array element in a file: `columns` numbers of one type.
template <class T>
struct Layout;
template <>
struct Layout<std::uint8_t> {
  static hid_t type() { return H5T_NATIVE_UINT8; }
  static constexpr hsize_t columns = 1;
};
template <>
struct Layout<std::uint32_t> {
  static hid_t type() { return H5T_NATIVE_UINT32; }
  static constexpr hsize_t columns = 1;
};
template <>
struct Layout<std::int64_t> {
  static hid_t type() { return H5T_NATIVE_INT64; }
  static constexpr hsize_t columns = 1;
};
template <>
struct Layout<double> {
  static hid_t type() { return H5T_NATIVE_DOUBLE; }
  static constexpr hsize_t columns = 1;
};
template <>
struct Layout<float> {
  static hid_t type() { return H5T_NATIVE_FLOAT; }
  static constexpr hsize_t columns = 1;
};
template <>
struct Layout<Vec3> : Layout<double> {
  static constexpr hsize_t columns = 3;
};
template <>
struct Layout<Vec3f> : Layout<float> {
  static constexpr hsize_t columns = 3;
};
template <class T>
struct Layout<SymTensorOf<T>> : Layout<T> {
  static constexpr hsize_t columns = 6;  ///< xx, yy, zz, xy, xz, yz
};
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(SymTensor) == 6 * sizeof(double));
static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(SymTensorf) == 6 * sizeof(float));

/// Makes a file in memory, calls `fill` on it and returns its bytes. Its metadata carry checksums
/// (format of HDF5 1.10) and no time stamps, so equal content gives equal bytes.
std::string new_file(const std::function<void(hid_t file)>& fill);
/// Opens a file from its bytes. Throws Failure for bytes that are not a whole HDF5 file.
Handle open_bytes(const std::string& bytes);

Handle new_group(hid_t parent, const char* name);
Handle open_group(hid_t parent, const char* name);
/// Throws Failure for links that are not hard, since they may lead to other files.
bool has(hid_t parent, const char* name);

/// Writes a dataset of shape (rows) or (rows, columns): chunked, compressed (shuffle, gzip) and
/// checksummed (fletcher32). Returns the open dataset, for attributes.
Handle write_array(hid_t parent, const char* name, hid_t type, hsize_t rows, hsize_t columns,
                   const void* data);
template <class T>
Handle write_array(hid_t parent, const char* name, std::span<const T> data) {
  return write_array(parent, name, Layout<T>::type(), data.size(), Layout<T>::columns, data.data());
}

/// The number of rows of a dataset. Throws Failure where its type or columns differ, where its
/// content lies in other files, and where it claims more rows than the file could hold.
hsize_t rows_of(hid_t parent, const char* name, hid_t type, hsize_t columns);
/// Fills `data` with all rows. Throws Failure where type or shape differ, or a checksum is wrong.
void read_array(hid_t parent, const char* name, hid_t type, hsize_t rows, hsize_t columns,
                void* data);
template <class T>
void read_array(hid_t parent, const char* name, std::span<T> data) {
  read_array(parent, name, Layout<T>::type(), data.size(), Layout<T>::columns, data.data());
}

/// Writes an attribute of shape (values.size()). Readers of SWIFT files expect length 1 and no
/// scalars.
void write_attribute(hid_t object, const char* name, std::span<const double> values);
void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::int64_t value);
/// Writes a scalar string of fixed length, since yt cannot read variable ones.
void write_attribute(hid_t object, const char* name, const std::string& text);

bool has_attribute(hid_t object, const char* name);
double read_double(hid_t object, const char* name);
std::int64_t read_integer(hid_t object, const char* name);
std::string read_text(hid_t object, const char* name);

}  // namespace eerie::io::h5
