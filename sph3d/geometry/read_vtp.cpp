#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <fstream>
#include <regex>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "sph3d/geometry/soup.hpp"
#include "sph3d/geometry/surface_array.hpp"
#include "sph3d/geometry/vtk_messages.hpp"

namespace ostium::sph3d {
namespace {

/// VTK would allocate whatever a damaged file announces; no compression reaches a thousandfold.
void check_announced_sizes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(1 << 16, '\0');
  in.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(in.gcount()));
  if (head.empty()) user_error("{}: the file is empty", file.string());
  if (head.find("<VTKFile") == head.npos || head.find("PolyData") == head.npos)
    user_error("{}: not a VTP file (no <VTKFile type=\"PolyData\"> in it)", file.string());
  const double most = 1000.0 * double(std::filesystem::file_size(file));
  static const std::regex announced("NumberOf(Points|Polys|Verts|Lines|Strips)=\"([0-9]+)\"");
  for (std::sregex_iterator match(head.begin(), head.end(), announced), end; match != end; ++match)
    if (std::stod((*match)[2]) > most)
      user_error("{}: announces {} {}, more than a file of its size can hold; it is damaged", file.string(),
                 (*match)[2].str(), (*match)[1].str());
}

vtkSmartPointer<vtkPolyData> load(const std::filesystem::path& file) {
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  std::string error;
  try {
    reader->Update();
    error = messages.first_error();
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!error.empty())
    user_error("{}: not a readable VTP file ({}); it is truncated or damaged", file.string(), error);
  return reader->GetOutput();
}

vtkDataArray* face_labels(vtkPolyData& data) {
  for (const char* name : {"ModelFaceID", "CapID"})
    if (auto* labels = data.GetCellData()->GetArray(name)) return labels;
  return nullptr;
}

void add_polygon(Soup& soup, vtkIdType count, const vtkIdType* corner, const std::filesystem::path& file) {
  for (vtkIdType k = 0; k < count; ++k)
    if (corner[k] < 0 || corner[k] >= vtkIdType(soup.points.size()))
      user_error("{}: a polygon uses the point {}, but there are {}; the file is damaged", file.string(),
                 corner[k], soup.points.size());
  for (vtkIdType k = 2; k < count; ++k)
    soup.facets.push_back({int(corner[0]), int(corner[k - 1]), int(corner[k])});
}

void add_points(Soup& soup, vtkPolyData& data, const std::filesystem::path& file) {
  soup.points.resize(std::size_t(data.GetNumberOfPoints()));
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    data.GetPoint(vtkIdType(i), soup.points[i].data());
    if (!soup.points[i].allFinite()) user_error("{}: the point {} is not finite", file.string(), i);
  }
}

void add_polygons(Soup& soup, vtkPolyData& data, const std::filesystem::path& file) {
  auto* labels = face_labels(data);
  // Cell data are numbered verts, lines, polygons.
  const vtkIdType first = data.GetNumberOfVerts() + data.GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
  bool split = false;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count;
    const vtkIdType* corner;
    cells->GetCurrentCell(count, corner);
    add_polygon(soup, count, corner, file);
    split = split || count > 3;
    const auto cell = first + cells->GetCurrentCellId();
    if (labels && cell >= labels->GetNumberOfTuples())
      user_error("{}: {} has fewer values than there are polygons; the file is damaged", file.string(),
                 labels->GetName());
    if (labels) soup.face_id.resize(soup.facets.size(), int(labels->GetComponent(cell, 0)));
  }
  if (split) soup.notes.push_back("polygons with more than three corners were cut into triangles");
}

/// SimVascular writes the names of the faces beside its VTP: set gPolyDataFaceNames(3) {inflow}.
void read_face_names(Soup& soup, const std::filesystem::path& file) {
  std::ifstream in(file.string() + ".facenames");
  static const std::regex entry(R"(gPolyDataFaceNames\((\d{1,9})\)\s*\{([^}]*)\})");
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, entry)) soup.face_name[std::stoi(match[1])] = match[2];
}

}  // namespace

Soup read_vtp(const std::filesystem::path& file) {
  check_announced_sizes(file);
  const auto data = load(file);
  if (data->GetNumberOfStrips() > 0)
    user_error("{}: holds triangle strips; save it with plain triangles (in ParaView: filter Triangulate)",
               file.string());
  Soup soup;
  add_points(soup, *data, file);
  add_polygons(soup, *data, file);
  if (soup.facets.empty()) user_error("{}: the VTP file holds no polygon", file.string());
  read_face_names(soup, file);
  return soup;
}

namespace {

vtkDataArray* point_array(vtkPolyData& data, const std::string& name, const std::filesystem::path& file) {
  std::vector<std::string> names;
  for (int k = 0; k < data.GetPointData()->GetNumberOfArrays(); ++k)
    if (const char* known = data.GetPointData()->GetArrayName(k)) names.emplace_back(known);
  auto* values = data.GetPointData()->GetArray(name.c_str());
  if (!values)
    user_error("{}: has no point array \"{}\"{}", file.string(), name,
               names.empty() ? "; it has none at all" : did_you_mean(name, names));
  if (values->GetNumberOfComponents() != 1)
    user_error("{}: the point array \"{}\" has {} components, one is wanted", file.string(), name,
               values->GetNumberOfComponents());
  if (values->GetNumberOfTuples() != data.GetNumberOfPoints())
    user_error("{}: the point array \"{}\" has {} values for {} points; the file is damaged", file.string(),
               name, values->GetNumberOfTuples(), data.GetNumberOfPoints());
  return values;
}

}  // namespace

std::vector<double> surface_array(const std::filesystem::path& file, const std::string& name,
                                  double length_unit, const Surface<3>& surface) {
  if (file.extension() != ".vtp")
    user_error("{}: only VTP files have point arrays; save the surface as VTP with \"{}\" in it",
               file.string(), name);
  check_announced_sizes(file);
  const auto data = load(file);
  auto* values = point_array(*data, name, file);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  std::vector<double> result;
  for (const Vec3& x : surface.points) {
    const Vec3 in_file = x / length_unit;
    const double value = values->GetComponent(locator->FindClosestPoint(in_file.data()), 0);
    if (!std::isfinite(value))
      user_error("{}: the point array \"{}\" is not a number near ({:.4g}, {:.4g}, {:.4g})", file.string(),
                 name, in_file.x(), in_file.y(), in_file.z());
    result.push_back(value);
  }
  return result;
}

}  // namespace ostium::sph3d
