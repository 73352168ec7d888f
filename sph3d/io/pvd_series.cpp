#include "sph3d/io/pvd_series.hpp"

#include <fstream>
#include <regex>

#include "sph3d/io/replace_file.hpp"

namespace ostium::sph3d {

PvdSeries::PvdSeries(std::filesystem::path file) : file_(std::move(file)) {}

void PvdSeries::resume(double time) {
  static const std::regex entry(R"re(<DataSet timestep="([^"]*)" file="([^"]*)"/>)re");
  std::ifstream in(file_);
  std::smatch match;
  entries_.clear();
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, entry) && std::stod(match[1]) <= time)
      entries_.push_back({std::stod(match[1]), match[2]});
}

void PvdSeries::add(double time, const std::filesystem::path& data) {
  const auto folder = std::filesystem::absolute(file_).parent_path();
  entries_.push_back({time, std::filesystem::absolute(data).lexically_relative(folder).generic_string()});
  write();
}

void PvdSeries::write() const {
  replace_file(file_, [&](const std::filesystem::path& part) {
    std::ofstream out(part);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n"
           "<Collection>\n";
    for (const auto& [time, data] : entries_)
      out << fmt::format("<DataSet timestep=\"{:.12g}\" file=\"{}\"/>\n", time, data);
    out << "</Collection>\n</VTKFile>\n";
    out.close();
    return bool(out);
  });
}

}  // namespace ostium::sph3d
