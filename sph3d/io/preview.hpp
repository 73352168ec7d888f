/// One picture of a vessel: translucent, its openings coloured, named and measured, with a scale.
///
///   title   first line of the picture
///   notes   lines in the column on the left below the table of openings (the network, say); long ones are cut
///
/// Rendered by OpenGL through X: on a virtual display (Xvfb) started for the purpose, or, where Xvfb is missing, on
/// the one of DISPLAY. Throws UserError when there is neither, or the picture cannot be written.
#pragma once
#include <filesystem>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

struct PreviewOptions {
  std::string title = {};
  std::vector<std::string> notes = {};
  int width = 1600, height = 1000;
};

template <int D>
void preview(const Lumen<D>& lumen, const PreviewOptions& options, const std::filesystem::path& png);

}  // namespace ostium::sph3d
