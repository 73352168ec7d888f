#include "fields.hpp"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <stdexcept>

namespace ostium::test {

PointFile read_points(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  PointFile result;
  result.points.resize(data.GetNumberOfPoints());
  for (std::size_t i = 0; i < result.points.size(); ++i) data.GetPoint(vtkIdType(i), result.points[i].data());
  for (int k = 0; k < data.GetPointData()->GetNumberOfArrays(); ++k) {
    vtkDataArray& array = *data.GetPointData()->GetArray(k);
    auto& values = result.fields[array.GetName()];
    values.assign(result.points.size(), {});
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int c = 0; c < std::min(array.GetNumberOfComponents(), 3); ++c)
        values[i][c] = array.GetComponent(vtkIdType(i), c);
  }
  return result;
}

std::vector<std::filesystem::path> last_files(const std::filesystem::path& folder, const std::string& prefix,
                                              double share) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(prefix) && entry.path().extension() == ".vtp")
      files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error("no " + prefix + "*.vtp in " + folder.string());
  std::sort(files.begin(), files.end());
  files.erase(files.begin(), files.begin() + static_cast<std::ptrdiff_t>((1 - share) * files.size()));
  return files;
}

}  // namespace ostium::test
