#include "solver/io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace eerie::io::h5 {

namespace {

constexpr hsize_t chunk_rows = 16384;  ///< 128 kB of one number, 768 kB of a tensor
constexpr unsigned gzip_level = 1;
/// Deflate cannot shrink further than about 1 : 1030; shapes that claim more are not real. No array
/// takes more memory than the whole file times this.
constexpr hsize_t most_compression = 1100;

/// Keeps the innermost reason, which comes first on the way up.
herr_t first_reason(unsigned n, const H5E_error2_t* error, void* text) {
  if (n == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

[[noreturn]] void fail(const std::string& doing) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first_reason, &reason);
  throw Failure(reason.empty() ? doing : doing + ": " + reason);
}

std::string named(const char* what, const char* name) { return fmt::format("{} '{}'", what, name); }

void write_values(hid_t object, const char* name, hid_t type, hsize_t count, const void* values) {
  const Handle space(checked(H5Screate_simple(1, &count, nullptr), name), H5Sclose);
  const Handle attribute(checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                                 named("creating attribute", name)),
                         H5Aclose);
  require(H5Awrite(attribute, type, values), named("writing attribute", name));
}

Handle open_attribute(hid_t object, const char* name) {
  if (!has_attribute(object, name)) throw Failure(named("it has no attribute", name));
  return {checked(H5Aopen(object, name, H5P_DEFAULT), named("opening attribute", name)), H5Aclose};
}

/// Reads the single value of an attribute of exactly this type.
void read_value(hid_t object, const char* name, hid_t type, void* value) {
  const Handle attribute = open_attribute(object, name);
  const Handle file_type(checked(H5Aget_type(attribute), named("type of attribute", name)),
                         H5Tclose);
  const Handle space(checked(H5Aget_space(attribute), named("shape of attribute", name)), H5Sclose);
  if (H5Tequal(file_type, type) <= 0 || H5Sget_simple_extent_npoints(space) != 1)
    throw Failure(named("wrong type or shape of attribute", name));
  require(H5Aread(attribute, type, value), named("reading attribute", name));
}

hsize_t file_size(hid_t object) {
  const Handle file(checked(H5Iget_file_id(object), "file of an object"), H5Fclose);
  hsize_t size = 0;
  require(H5Fget_filesize(file, &size), "size of the file");
  return size;
}

/// Throws Failure unless the content of a dataset lies in this file, in chunks no larger than the
/// file could hold.
void require_inside(hid_t dataset, const char* name) {
  const Handle creation(checked(H5Dget_create_plist(dataset), named("layout of dataset", name)),
                        H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (H5Pget_external_count(creation) != 0 || layout == H5D_VIRTUAL)
    throw Failure(named("it takes numbers from other files in dataset", name));
  if (layout != H5D_CHUNKED) return;
  std::array<hsize_t, H5S_MAX_RANK> sides{};
  const int rank = H5Pget_chunk(creation, static_cast<int>(sides.size()), sides.data());
  require(rank, named("chunks of dataset", name));
  const hsize_t most = most_compression * file_size(dataset);
  hsize_t numbers = 1;
  for (int k = 0; k < rank; ++k) {
    const hsize_t side = sides[static_cast<std::size_t>(k)];
    if (side > most / numbers) throw Failure(named("chunks larger than the file in dataset", name));
    numbers *= side;
  }
}

/// An open dataset after its type, rank and columns were found right.
struct Array {
  Handle dataset;
  hsize_t rows;
};
Array open_array(hid_t parent, const char* name, hid_t type, hsize_t columns) {
  if (!has(parent, name)) throw Failure(named("it has no dataset", name));
  Handle dataset(checked(H5Dopen2(parent, name, H5P_DEFAULT), named("opening dataset", name)),
                 H5Dclose);
  require_inside(dataset, name);
  const Handle file_type(checked(H5Dget_type(dataset), named("type of dataset", name)), H5Tclose);
  if (H5Tequal(file_type, type) <= 0) throw Failure(named("wrong number type in dataset", name));
  const Handle space(checked(H5Dget_space(dataset), named("shape of dataset", name)), H5Sclose);
  std::array<hsize_t, 2> dims{0, 1};
  const int rank = H5Sget_simple_extent_ndims(space);
  const int wanted_rank = columns == 1 ? 1 : 2;
  if (rank != wanted_rank || H5Sget_simple_extent_dims(space, dims.data(), nullptr) != rank ||
      dims[1] != columns)
    throw Failure(fmt::format("dataset '{}' must have shape ({})", name,
                              columns == 1 ? "N" : fmt::format("N, {}", columns)));
  // What an index says of its chunks may be forged too.
  const hsize_t stored = std::min(H5Dget_storage_size(dataset), file_size(dataset));
  if (dims[0] > stored * most_compression / (columns * H5Tget_size(type)))
    throw Failure(fmt::format("dataset '{}' claims {} rows but holds {} bytes", name, dims[0],
                              static_cast<unsigned long long>(stored)));
  return {std::move(dataset), dims[0]};
}

Handle memory_access() {
  Handle access(checked(H5Pcreate(H5P_FILE_ACCESS), "file access list"), H5Pclose);
  require(H5Pset_fapl_core(access, std::size_t{1} << 20, false), "file in memory");
  // Only the newest format has a checksum on every piece of metadata.
  require(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "format version");
  // No space set aside for later: the file ends where its content ends.
  require(H5Pset_meta_block_size(access, 0), "file in memory");
  require(H5Pset_small_data_block_size(access, 0), "file in memory");
  // Nor do files have libraries loaded, for filters that they name.
  require(H5PLset_loading_state(0), "no plugins");
  return access;
}

/// Catches the buffer of a file in memory at the moment when it is closed. (H5Fget_file_image()
/// would do the same for an open file, but leaves its superblock with a wrong checksum.)
struct FileImage {
  std::size_t size = 0;  ///< of the file; the buffer is longer
  std::string bytes;
};
H5FD_file_image_callbacks_t image_callbacks(FileImage& image) {
  using Op = H5FD_file_image_op_t;
  H5FD_file_image_callbacks_t c{};
  c.image_malloc = [](size_t size, Op, void*) { return std::malloc(size); };
  c.image_memcpy = [](void* to, const void* from, size_t size, Op, void*) {
    return std::memcpy(to, from, size);
  };
  c.image_realloc = [](void* buffer, size_t size, Op, void*) { return std::realloc(buffer, size); };
  c.image_free = [](void* buffer, Op op, void* user) {
    FileImage& caught = *static_cast<FileImage*>(user);
    if (op == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
      caught.bytes.assign(static_cast<const char*>(buffer), caught.size);
    std::free(buffer);
    return herr_t{0};
  };
  c.udata_copy = [](void* user) { return user; };
  c.udata_free = [](void*) { return herr_t{0}; };
  c.udata = &image;
  return c;
}

/// Creation list without time stamps: equal content gives equal bytes.
Handle timeless(hid_t list_class) {
  Handle list(checked(H5Pcreate(list_class), "creation list"), H5Pclose);
  require(H5Pset_obj_track_times(list, false), "time stamps off");
  return list;
}

}  // namespace

hid_t checked(hid_t id, const std::string& doing) {
  if (id < 0) fail(doing);
  return id;
}

void require(herr_t status, const std::string& doing) {
  if (status < 0) fail(doing);
}

std::string new_file(const std::function<void(hid_t)>& fill) {
  FileImage image;
  const Handle access = memory_access();
  const Handle creation = timeless(H5P_FILE_CREATE);
  H5FD_file_image_callbacks_t callbacks = image_callbacks(image);
  require(H5Pset_file_image_callbacks(access, &callbacks), "file in memory");
  Handle file(checked(H5Fcreate("in-memory", H5F_ACC_TRUNC, creation, access), "creating the file"),
              H5Fclose);
  fill(file);
  require(H5Fflush(file, H5F_SCOPE_GLOBAL), "finishing the file");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size < 0 ? -1 : 0, "size of the file");
  image.size = static_cast<std::size_t>(size);
  require(H5Fclose(file.release()), "closing the file");
  if (image.bytes.size() != image.size) throw Failure("the file in memory was cut");
  return std::move(image.bytes);
}

Handle open_bytes(const std::string& bytes) {
  static const std::string signature = "\x89HDF\r\n\x1a\n";
  if (bytes.empty()) throw Failure("it is empty");
  if (!bytes.starts_with(signature)) throw Failure("it is not an HDF5 file");
  const Handle access = memory_access();
  // The library copies the bytes and, read-only, does not change them.
  require(H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()),
          "file in memory");
  return {checked(H5Fopen("in-memory", H5F_ACC_RDONLY, access), "it is torn or damaged"), H5Fclose};
}

Handle new_group(hid_t parent, const char* name) {
  const Handle creation = timeless(H5P_GROUP_CREATE);
  return {checked(H5Gcreate2(parent, name, H5P_DEFAULT, creation, H5P_DEFAULT),
                  named("creating group", name)),
          H5Gclose};
}

Handle open_group(hid_t parent, const char* name) {
  if (!has(parent, name)) throw Failure(named("it has no group", name));
  return {checked(H5Gopen2(parent, name, H5P_DEFAULT), named("opening group", name)), H5Gclose};
}

bool has(hid_t parent, const char* name) {
  const htri_t there = H5Lexists(parent, name, H5P_DEFAULT);
  if (there < 0) fail(named("looking for", name));
  if (there == 0) return false;
  H5L_info_t link;
  require(H5Lget_info(parent, name, &link, H5P_DEFAULT), named("looking at", name));
  // Others lead to other files, or to links that do.
  if (link.type != H5L_TYPE_HARD) throw Failure(named("it only has a link to elsewhere for", name));
  return true;
}

Handle write_array(hid_t parent, const char* name, hid_t type, hsize_t rows, hsize_t columns,
                   const void* data) {
  const std::string doing = named("writing dataset", name);
  const int rank = columns == 1 ? 1 : 2;
  const std::array<hsize_t, 2> dims{rows, columns};
  const std::array<hsize_t, 2> chunk{std::min(rows, chunk_rows), columns};
  const Handle space(checked(H5Screate_simple(rank, dims.data(), nullptr), doing), H5Sclose);
  const Handle creation = timeless(H5P_DATASET_CREATE);
  require(H5Pset_chunk(creation, rank, chunk.data()), doing);
  require(H5Pset_shuffle(creation), doing);
  require(H5Pset_deflate(creation, gzip_level), doing);
  require(H5Pset_fletcher32(creation), doing);
  Handle dataset(
      checked(H5Dcreate2(parent, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), doing),
      H5Dclose);
  require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), doing);
  return dataset;
}

hsize_t rows_of(hid_t parent, const char* name, hid_t type, hsize_t columns) {
  return open_array(parent, name, type, columns).rows;
}

void read_array(hid_t parent, const char* name, hid_t type, hsize_t rows, hsize_t columns,
                void* data) {
  const Array array = open_array(parent, name, type, columns);
  if (array.rows != rows)
    throw Failure(fmt::format("dataset '{}' has {} rows, expected {}", name, array.rows, rows));
  require(H5Dread(array.dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
          named("reading dataset", name));
}

void write_attribute(hid_t object, const char* name, std::span<const double> values) {
  write_values(object, name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}
void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values) {
  write_values(object, name, H5T_NATIVE_INT64, values.size(), values.data());
}
void write_attribute(hid_t object, const char* name, double value) {
  write_values(object, name, H5T_NATIVE_DOUBLE, 1, &value);
}
void write_attribute(hid_t object, const char* name, std::int64_t value) {
  write_values(object, name, H5T_NATIVE_INT64, 1, &value);
}
void write_attribute(hid_t object, const char* name, const std::string& text) {
  const std::string doing = named("writing attribute", name);
  const Handle type(checked(H5Tcopy(H5T_C_S1), doing), H5Tclose);
  require(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), doing);
  require(H5Tset_strpad(type, H5T_STR_NULLPAD), doing);
  const Handle space(checked(H5Screate(H5S_SCALAR), doing), H5Sclose);
  const Handle attribute(
      checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), doing), H5Aclose);
  require(H5Awrite(attribute, type, text.c_str()), doing);
}

bool has_attribute(hid_t object, const char* name) {
  const htri_t there = H5Aexists(object, name);
  if (there < 0) fail(named("looking for attribute", name));
  return there > 0;
}

double read_double(hid_t object, const char* name) {
  double value = 0;
  read_value(object, name, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t read_integer(hid_t object, const char* name) {
  std::int64_t value = 0;
  read_value(object, name, H5T_NATIVE_INT64, &value);
  return value;
}

std::string read_text(hid_t object, const char* name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(checked(H5Aget_type(attribute), named("type of attribute", name)), H5Tclose);
  const Handle space(checked(H5Aget_space(attribute), named("shape of attribute", name)), H5Sclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Sget_simple_extent_npoints(space) != 1)
    throw Failure(named("wrong type or shape of attribute", name));
  const std::size_t size = H5Tget_size(type);
  if (size > file_size(object))
    throw Failure(named("a text longer than the file in attribute", name));
  std::string text(size, '\0');
  require(H5Aread(attribute, type, text.data()), named("reading attribute", name));
  return text;
}

}  // namespace eerie::io::h5
