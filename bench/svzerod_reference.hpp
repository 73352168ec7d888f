/// How far a run is from the refined results of svZeroDSolver: `converged/` of its reference cases.
///
///   error   l2(ours - reference)/l2(reference) over the times of the reference in the last cycle, of the worst series
///
/// Ours goes linearly between its rows. Not checked: that the reference is converged (its manifest says how far).
#pragma once
#include <filesystem>
#include <string>

namespace ostium::bench {

struct Distance {
  double error = 0;
  std::string series;  // the worst one
};

/// results: folder with svzerod.csv of the last cycle; data: folder of the reference cases.
Distance distance_to_reference(const std::filesystem::path& results, const std::filesystem::path& data,
                               const std::string& name);

}  // namespace ostium::bench
