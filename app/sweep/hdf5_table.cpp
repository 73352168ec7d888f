#include "app/sweep/hdf5_table.hpp"

#include <hdf5.h>

#include <algorithm>

#include "app/checkpoint/hdf5_handle.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

constexpr hsize_t chunk_rows = 1 << 14;

using Handle = Hdf5Handle;

bool write_names(hid_t set, const std::vector<std::string>& names) {
  const hsize_t count = names.size();
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  std::vector<const char*> texts;
  for (const auto& name : names) texts.push_back(name.c_str());
  const Handle attribute(H5Acreate2(set, "names", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, type, texts.data()) >= 0;
}

/// rows x columns, chunk by chunk; fill(row, cells) gives one row.
template <class T, class Fill>
bool write_set(hid_t file, const char* name, hid_t type, hsize_t rows, hsize_t columns,
               const std::vector<std::string>& names, Fill fill) {
  const hsize_t size[2] = {rows, columns}, chunk[2] = {std::min(rows, chunk_rows), columns};
  const int rank = columns > 0 ? 2 : 1;
  const hsize_t width = std::max<hsize_t>(columns, 1);
  const Handle space(H5Screate_simple(rank, size, nullptr), H5Sclose),
      layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(layout, rank, chunk), H5Pset_shuffle(layout), H5Pset_fletcher32(layout);
  const Handle set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, layout, H5P_DEFAULT), H5Dclose);
  if (set < 0 || !write_names(set, names)) return false;
  std::vector<T> cells(chunk[0] * width);
  for (hsize_t begin = 0; begin < rows; begin += chunk_rows) {
    const hsize_t from[2] = {begin, 0}, count[2] = {std::min(rows - begin, chunk_rows), columns};
    for (hsize_t i = 0; i < count[0]; ++i) fill(static_cast<std::int64_t>(begin + i), &cells[i * width]);
    const Handle part(H5Screate_simple(rank, count, nullptr), H5Sclose);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, from, nullptr, count, nullptr);
    if (H5Dwrite(set, type, part, space, H5P_DEFAULT, cells.data()) < 0) return false;
  }
  return true;
}

bool write_sets(hid_t file, const SweepPlan& plan, const SweepTable& table) {
  const auto rows = static_cast<hsize_t>(table.rows()), results = static_cast<hsize_t>(plan.results.size());
  const auto parameters = static_cast<std::size_t>(plan.design.columns());
  std::vector<std::string> words;
  for (const auto outcome : {network::Outcome::ok, network::Outcome::failed, network::Outcome::refused})
    words.push_back(word(outcome));
  return write_set<double>(file, "parameters", H5T_NATIVE_DOUBLE, rows, parameters, plan.parameter_columns(),
                           [&](std::int64_t i, double* cells) {
                             plan.design.row(i, {cells, parameters});
                           }) &&
         write_set<double>(file, "results", H5T_NATIVE_DOUBLE, rows, results, plan.result_columns(),
                           [&](std::int64_t i, double* cells) {
                             for (hsize_t k = 0; k < results; ++k) cells[k] = table.result(i, k);
                           }) &&
         write_set<std::uint8_t>(file, "status", H5T_NATIVE_UINT8, rows, 0, words,
                                 [&](std::int64_t i, std::uint8_t* cell) {
                                   *cell = static_cast<std::uint8_t>(table.outcome(i));
                                 });
}

}  // namespace

void write_hdf5(const std::filesystem::path& path, const SweepPlan& plan, const SweepTable& table) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are told as ours
  const std::filesystem::path beside = path.string() + ".part";
  Handle file(H5Fcreate(beside.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  const bool written = file >= 0 && write_sets(file, plan, table) && file.close();
  std::error_code failed;
  if (written) std::filesystem::rename(beside, path, failed);
  if (!written || failed) user_error("{}: this file cannot be written; is the disk full?", path.string());
}

}  // namespace ostium::app
