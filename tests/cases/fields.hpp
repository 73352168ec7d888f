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

/// The file with the highest number in results/fields, such as the last of fluid_*.vtp.
std::filesystem::path last_file(const std::filesystem::path& folder, const std::string& prefix);

}  // namespace ostium::test
