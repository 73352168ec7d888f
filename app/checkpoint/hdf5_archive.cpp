#include "app/checkpoint/hdf5_archive.hpp"

#include <hdf5.h>

#include <algorithm>

#include "app/checkpoint/hdf5_handle.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

using Handle = Hdf5Handle;

/// The newest format has checksums of its structure too.
hid_t newest_format() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  return access;
}

hid_t create(const std::filesystem::path& path) {
  const Handle access(newest_format(), H5Pclose);
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
}

template <class Kind>
hid_t type_of(Kind kind) {
  switch (kind) {
    case Kind::real:
      return H5T_NATIVE_DOUBLE;
    case Kind::single:
      return H5T_NATIVE_FLOAT;
    case Kind::integer:
      return H5T_NATIVE_INT64;
    case Kind::byte:
      return H5T_NATIVE_UINT8;
  }
  return -1;
}

/// Chunks of about a million records, each with a checksum.
hid_t checked_layout(hsize_t records, hsize_t per_record) {
  const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
  if (records == 0) return layout;
  const hsize_t chunk[2] = {std::min<hsize_t>(records, 1 << 20), per_record};
  H5Pset_chunk(layout, 2, chunk);
  H5Pset_fletcher32(layout);
  return layout;
}

hid_t with_groups() {
  const hid_t link = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(link, 1);
  return link;
}

}  // namespace

struct Hdf5Archive::File : Handle {
  explicit File(hid_t id) : Handle(id, H5Fclose) {}
};

Hdf5Archive::Hdf5Archive(std::filesystem::path path) : path_(std::move(path)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are told as ours
}

Hdf5Archive::~Hdf5Archive() = default;

void Hdf5Archive::misfit(const std::string& name, const std::string& problem) const {
  user_error(
      "{}: this checkpoint is damaged or of another kind: {}{}: {}; start the run anew without --resume",
      path_.string(), prefix_, name, problem);
}

Hdf5Writer::Hdf5Writer(std::filesystem::path path)
    : Hdf5Archive(std::move(path)), beside_(path_.string() + ".part") {
  file_ = std::make_unique<File>(create(beside_));
  if (!file_->good()) give_up();
}

Hdf5Writer::~Hdf5Writer() {
  if (!file_->good()) return;
  file_->close();
  std::error_code ignored;
  std::filesystem::remove(beside_, ignored);
}

void Hdf5Writer::give_up() const {
  user_error("{}: the checkpoint cannot be written; is the folder there, writable, the disk not full?",
             path_.string());
}

void Hdf5Writer::finish() {
  std::error_code failed;
  if (!file_->close()) give_up();
  std::filesystem::rename(beside_, path_, failed);
  if (failed) give_up();
}

void Hdf5Writer::array(const std::string& name, Kind kind, std::size_t records, std::size_t per_record,
                       const Place& place) {
  const hsize_t size[2] = {records, per_record};
  const Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
  const Handle layout(checked_layout(records, per_record), H5Pclose), link(with_groups(), H5Pclose);
  Handle set(H5Dcreate2(*file_, (prefix_ + name).c_str(), type_of(kind), space, link, layout, H5P_DEFAULT),
             H5Dclose);
  const bool written = set.good() && (records == 0 || H5Dwrite(set, type_of(kind), H5S_ALL, H5S_ALL,
                                                               H5P_DEFAULT, place(records)) >= 0);
  if (!written || !set.close()) give_up();
}

Hdf5Reader::Hdf5Reader(std::filesystem::path path) : Hdf5Archive(std::move(path)) {
  file_ = std::make_unique<File>(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (!file_->good())
    user_error("{}: this checkpoint is damaged or no checkpoint at all; start the run anew without --resume",
               path_.string());
}

void Hdf5Reader::array(const std::string& name, Kind kind, std::size_t, std::size_t per_record,
                       const Place& place) {
  const Handle set(H5Dopen2(*file_, (prefix_ + name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.good()) misfit(name, "it is missing");
  const Handle space(H5Dget_space(set), H5Sclose), type(H5Dget_type(set), H5Tclose);
  hsize_t size[2] = {0, 0};
  if (H5Sget_simple_extent_ndims(space) != 2 || H5Sget_simple_extent_dims(space, size, nullptr) != 2 ||
      H5Tequal(type, type_of(kind)) <= 0)
    misfit(name, "numbers of another kind");
  if (size[1] != per_record)
    misfit(name, fmt::format("records of {} numbers, this program has {}", size[1], per_record));
  void* target = place(size[0]);
  if (size[0] > 0 && H5Dread(set, type_of(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, target) < 0)
    misfit(name, "its checksum does not fit");
}

}  // namespace ostium::app
