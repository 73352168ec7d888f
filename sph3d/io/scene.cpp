#include "sph3d/io/scene.hpp"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Eigenvalues>

#include "sph3d/geometry/outline.hpp"

namespace ostium::sph3d {
namespace {

vtkNew<vtkPolyData> facets_with(const Surface<3>& surface, int label) {
  vtkNew<vtkPoints> points;
  for (const auto& x : surface.points) points->InsertNextPoint(x.data());
  vtkNew<vtkCellArray> cells;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.label[f] != label) continue;
    cells->InsertNextCell(3);
    for (int v : surface.facets[f]) cells->InsertCellPoint(v);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkNew<vtkActor> shown(vtkPolyData& data, const Colour& colour, double opacity) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(&data);
  normals->SetFeatureAngle(50);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetSpecular(0.25);
  actor->GetProperty()->SetSpecularPower(30);
  return actor;
}

double diameter(const Opening<3>& o) { return std::sqrt(4 * o.area / pi); }

double arrow_length(const Lumen<3>& lumen, const Opening<3>& o) {
  const double across = bounds(lumen.surface.points).extent().norm();
  return std::clamp(1.3 * diameter(o), 0.05 * across, 0.10 * across);
}

void add_arrow(vtkRenderer& renderer, const Lumen<3>& lumen, int k) {
  const auto& o = lumen.openings[k];
  const double length = arrow_length(lumen, o);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipLength(0.38), arrow->SetTipRadius(0.13), arrow->SetShaftRadius(0.045);
  arrow->SetTipResolution(32), arrow->SetShaftResolution(24);
  const auto t = plane_frame(o.normal);
  vtkNew<vtkMatrix4x4> pose;  // the arrow lies along x
  for (int d = 0; d < 3; ++d) {
    pose->SetElement(d, 0, length * o.normal[d]);
    pose->SetElement(d, 1, length * t(d, 0));
    pose->SetElement(d, 2, length * t(d, 1));
    pose->SetElement(d, 3, o.centre[d]);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(arrow->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetUserMatrix(pose);
  const Colour colour = opening_colour(k);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer.AddActor(actor);
}

/// Axes of the point cloud, the thinnest first.
Mat<3> principal_axes(const Surface<3>& surface) {
  Vec3 mean = Vec3::Zero();
  Mat<3> spread = Mat<3>::Zero();
  double whole = 0;
  for (int f = 0; f < int(surface.facets.size()); ++f) {
    const double a = area_vector(surface, f).norm();
    mean += a * centroid(surface, f), whole += a;
  }
  mean /= whole;
  for (int f = 0; f < int(surface.facets.size()); ++f) {
    const Vec3 d = centroid(surface, f) - mean;
    spread += area_vector(surface, f).norm() * d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Mat<3>>(spread).eigenvectors();
}

}  // namespace

Colour opening_colour(int k) {
  static constexpr std::array<Colour, 8> palette = {{{0.12, 0.35, 0.75},
                                                     {0.85, 0.45, 0.05},
                                                     {0.10, 0.55, 0.30},
                                                     {0.55, 0.25, 0.65},
                                                     {0.00, 0.55, 0.60},
                                                     {0.75, 0.15, 0.45},
                                                     {0.50, 0.40, 0.10},
                                                     {0.30, 0.30, 0.35}}};
  return palette[k % palette.size()];
}

void add_vessel(vtkRenderer& renderer, const Lumen<3>& lumen) {
  const auto wall = facets_with(lumen.surface, -1);
  renderer.AddActor(shown(*wall, {0.82, 0.30, 0.26}, 0.32));
  for (int k = 0; k < int(lumen.openings.size()); ++k) {
    renderer.AddActor(shown(*facets_with(lumen.surface, k), opening_colour(k), 1));
    add_arrow(renderer, lumen, k);
  }
}

Vec3 arrow_tip(const Lumen<3>& lumen, const Opening<3>& o) {
  return o.centre + arrow_length(lumen, o) * o.normal;
}

void aim_camera(vtkRenderer& renderer, const Lumen<3>& lumen, const Vec2& pixels, const Vec2& margin) {
  const auto axes = principal_axes(lumen.surface);
  Vec3 view = axes.col(0);
  if (view.dot(Vec3(0.3, -1, 0.1)) > 0) view = -view;  // from the front of a patient, by DICOM's axes
  const Vec3 z = std::abs(view.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitY();
  const Vec3 right = view.cross(z).normalized(), up = right.cross(view);
  std::vector<Vec3> seen;  // in the frame of the camera
  for (const auto& x : lumen.surface.points) seen.emplace_back(right.dot(x), up.dot(x), view.dot(x));
  for (const auto& o : lumen.openings) {
    const Vec3 tip = arrow_tip(lumen, o);
    seen.emplace_back(right.dot(tip), up.dot(tip), view.dot(tip));
  }
  const auto box = bounds(seen);
  const Vec3 middle = 0.5 * (box.lower + box.upper), size = box.extent();
  const Vec3 focus = middle.x() * right + middle.y() * up + middle.z() * view;
  const Vec3 eye = focus - 3 * size.norm() * view;
  const double metre_per_pixel = (size.head<2>().array() / (pixels - 2 * margin).array()).maxCoeff();
  auto& camera = *renderer.GetActiveCamera();
  camera.SetFocalPoint(focus.data());
  camera.SetPosition(eye.data());
  camera.SetViewUp(up.data());
  camera.ParallelProjectionOn();
  camera.SetParallelScale(0.5 * pixels.y() * metre_per_pixel);
  renderer.ResetCameraClippingRange();
}

Vec2 pixel(vtkRenderer& renderer, const Vec3& x) {
  renderer.SetWorldPoint(x.x(), x.y(), x.z(), 1);
  renderer.WorldToDisplay();
  const double* at = renderer.GetDisplayPoint();
  return {at[0], at[1]};
}

Lumen<3> sheet(const Lumen<2>& lumen) {
  Lumen<3> flat;
  Polygon outline;
  // The facets of an outline follow one another, possibly backwards.
  std::vector<int> next(lumen.surface.points.size());
  for (const auto& [a, b] : lumen.surface.facets) next[a] = b;
  std::vector<int> order;
  for (int v = 0; order.empty() || v != 0; v = next[v])
    order.push_back(v), outline.push_back(lumen.surface.points[v]);
  for (const auto& x : lumen.surface.points) flat.surface.points.emplace_back(x.x(), x.y(), 0);
  for (const auto& [a, b, c] : triangulate(outline))
    flat.surface.facets.push_back({order[a], order[b], order[c]});
  flat.surface.label.assign(flat.surface.facets.size(), -1);
  for (const auto& o : lumen.openings) {
    Opening<3> flat_opening{.name = o.name, .area = pi / 4 * o.area * o.area};  // the circle of this diameter
    flat_opening.centre << o.centre, 0;
    flat_opening.normal << o.normal, 0;
    flat.openings.push_back(flat_opening);
  }
  flat.volume = lumen.volume, flat.wall_area = lumen.wall_area;
  return flat;
}

}  // namespace ostium::sph3d
