#include "sph3d/io/overlay.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace ostium::sph3d {
namespace {

void draw_cell(vtkRenderer& renderer, const std::vector<Vec2>& corners, const Colour& colour,
               double line_width) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cell;
  cell->InsertNextCell(int(corners.size()));
  for (const auto& x : corners) cell->InsertCellPoint(points->InsertNextPoint(x.x(), x.y(), 0));
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  if (corners.size() == 2)
    data->SetLines(cell);
  else
    data->SetPolys(cell);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetLineWidth(float(line_width));
  renderer.AddActor2D(actor);
}

}  // namespace

void draw_text(vtkRenderer& renderer, const Vec2& at, const std::string& text, const TextStyle& style) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(at.x(), at.y());
  auto* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(style.size);
  property->SetColor(style.colour[0], style.colour[1], style.colour[2]);
  property->SetBold(style.bold);
  if (style.on_white) property->SetBackgroundColor(1, 1, 1), property->SetBackgroundOpacity(0.7);
  if (style.right_aligned) property->SetJustificationToRight();
  property->SetVerticalJustificationToCentered();
  renderer.AddActor2D(actor);
}

void draw_line(vtkRenderer& renderer, const Vec2& from, const Vec2& to, const Colour& colour, double width) {
  draw_cell(renderer, {from, to}, colour, width);
}

void draw_rectangle(vtkRenderer& renderer, const Vec2& lower, const Vec2& upper, const Colour& colour) {
  draw_cell(renderer, {lower, Vec2(upper.x(), lower.y()), upper, Vec2(lower.x(), upper.y())}, colour, 1);
}

double text_width(const std::string& text, int size) { return 0.56 * size * double(text.size()); }

std::string fitted(const std::string& text, int size, double width) {
  if (text_width(text, size) <= width) return text;
  const auto most = std::size_t(std::max(0.0, width / (0.56 * size) - 3));
  return text.substr(0, most) + "...";
}

}  // namespace ostium::sph3d
