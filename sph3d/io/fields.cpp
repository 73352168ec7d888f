#include "sph3d/io/fields.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "sph3d/geometry/vtk_messages.hpp"
#include "sph3d/io/replace_file.hpp"

namespace ostium::sph3d {
namespace {

template <int D>
vtkNew<vtkPoints> vtk_points(std::span<const Vec<D>> points) {
  vtkNew<vtkPoints> out;
  out->SetDataTypeToFloat();
  out->SetNumberOfPoints(vtkIdType(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if constexpr (D == 2)
      out->SetPoint(vtkIdType(i), points[i].x(), points[i].y(), 0);
    else
      out->SetPoint(vtkIdType(i), points[i].data());
  }
  return out;
}

void add_field(vtkDataSetAttributes& data, const Field& field, std::size_t count) {
  OSTIUM_ASSERT(field.values.size() == count * field.components, "{}: {} values, {} points, {} components",
                field.name, field.values.size(), count, field.components);
  const int n = field.components, written = n == 2 ? 3 : n;
  vtkNew<vtkFloatArray> array;
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(written);
  array->SetNumberOfTuples(vtkIdType(count));
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < written; ++c)
      array->SetTypedComponent(vtkIdType(i), c, c < n ? field.values[i * n + c] : 0.0f);
  data.AddArray(array);
}

void write(const std::filesystem::path& file, vtkPolyData& data) {
  replace_file(file, [&](const std::filesystem::path& part) {
    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(part.c_str());
    writer->SetInputData(&data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    // fields are mostly noise in the low bits: to press harder costs time and saves little
    writer->SetCompressorTypeToLZ4();
    return writer->Write() == 1 && messages.first_error().empty();
  });
}

template <int D>
void add_facets(vtkPolyData& data, const Surface<D>& surface) {
  vtkNew<vtkCellArray> cells;
  for (const auto& facet : surface.facets) {
    cells->InsertNextCell(D);
    for (int v : facet) cells->InsertCellPoint(v);
  }
  if constexpr (D == 2)
    data.SetLines(cells);
  else
    data.SetPolys(cells);
  vtkNew<vtkIntArray> opening;
  opening->SetName("opening");
  for (int label : surface.label) opening->InsertNextValue(label);
  data.GetCellData()->AddArray(opening);
}

}  // namespace

Field field(std::string name, std::span<const double> values) {
  return {std::move(name), 1, std::vector<float>(values.begin(), values.end())};
}

Field field(std::string name, std::span<const float> values) {
  return {std::move(name), 1, std::vector<float>(values.begin(), values.end())};
}

template <int D>
Field field(std::string name, std::span<const Vec<D>> values) {
  Field f{std::move(name), D, {}};
  f.values.reserve(values.size() * D);
  for (const auto& v : values)
    for (int d = 0; d < D; ++d) f.values.push_back(float(v[d]));
  return f;
}

template <int D>
void write_particles_vtp(const std::filesystem::path& file, std::span<const Vec<D>> points,
                         std::span<const Field> fields) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points<D>(points));
  vtkNew<vtkCellArray> vertices;  // ParaView draws points only where there are cells
  if (!points.empty()) vertices->InsertNextCell(vtkIdType(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) vertices->InsertCellPoint(vtkIdType(i));
  data->SetVerts(vertices);
  for (const auto& f : fields) add_field(*data->GetPointData(), f, points.size());
  write(file, *data);
}

template <int D>
void write_surface_vtp(const std::filesystem::path& file, const Surface<D>& surface,
                       std::span<const Field> point_fields, std::span<const Field> facet_fields) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points<D>(std::span<const Vec<D>>(surface.points)));
  add_facets(*data, surface);
  for (const auto& f : point_fields) add_field(*data->GetPointData(), f, surface.points.size());
  for (const auto& f : facet_fields) add_field(*data->GetCellData(), f, surface.facets.size());
  write(file, *data);
}

template Field field<2>(std::string, std::span<const Vec2>);
template Field field<3>(std::string, std::span<const Vec3>);
template Field field<6>(std::string, std::span<const Vec<6>>);
template void write_particles_vtp(const std::filesystem::path&, std::span<const Vec2>,
                                  std::span<const Field>);
template void write_particles_vtp(const std::filesystem::path&, std::span<const Vec3>,
                                  std::span<const Field>);
template void write_surface_vtp(const std::filesystem::path&, const Surface<2>&, std::span<const Field>,
                                std::span<const Field>);
template void write_surface_vtp(const std::filesystem::path&, const Surface<3>&, std::span<const Field>,
                                std::span<const Field>);

}  // namespace ostium::sph3d
