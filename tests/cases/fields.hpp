/// Reads the point files (.vtp) that runs write for ParaView.
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ostium::test {

/// Points and their fields; scalars stand in the first component.
struct PointFile {
  std::vector<std::array<double, 3>> points;
  std::map<std::string, std::vector<std::array<double, 3>>> fields;
};

PointFile read_points(const std::filesystem::path& file);

/// The last files of a series, such as the last half (share 0.5) of fluid_*.vtp, in order of their numbers.
std::vector<std::filesystem::path> last_files(const std::filesystem::path& folder, const std::string& prefix,
                                              double share);

}  // namespace ostium::test
