/// The table of a large sweep as an HDF5 file, which programs read faster than text.
///
///   parameters   samples x parameters, double, SI;   attribute `names`, as the columns of sweep.csv
///   results      samples x results, double, SI, not a number where there is none;   attribute `names`
///   status       samples, 8-bit;   attribute `names`: what 0, 1, .. mean
///
/// Written under another name and renamed at the end: what is there is whole. Throws UserError where that fails.
#pragma once
#include "app/sweep/table.hpp"

namespace ostium::app {

inline constexpr std::int64_t rows_for_hdf5 = 100000;  // more are also written as HDF5

void write_hdf5(const std::filesystem::path& file, const SweepPlan& plan, const SweepTable& table);

}  // namespace ostium::app
