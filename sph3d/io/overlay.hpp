/// Text, lines and rectangles in pixels over a picture, origin at the lower left. Internal to io/.
#pragma once
#include <array>
#include <string>

#include "core/vec.hpp"

class vtkRenderer;

namespace ostium::sph3d {

using Colour = std::array<double, 3>;

struct TextStyle {
  int size = 20;
  Colour colour = {0.1, 0.1, 0.12};
  bool bold = false, right_aligned = false;
  bool on_white = false;  ///< on a whitish ground, to stand out from the vessel
};

void draw_text(vtkRenderer& renderer, const Vec2& at, const std::string& text, const TextStyle& style);
void draw_line(vtkRenderer& renderer, const Vec2& from, const Vec2& to, const Colour& colour, double width);
void draw_rectangle(vtkRenderer& renderer, const Vec2& lower, const Vec2& upper, const Colour& colour);

/// Width of the text in pixels, a little on the large side.
double text_width(const std::string& text, int size);

/// The text, or as much of its beginning as fits, with dots.
std::string fitted(const std::string& text, int size, double width);

}  // namespace ostium::sph3d
