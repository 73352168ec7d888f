#include "sph3d/io/preview.hpp"

#include <vtkAutoInit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/vtk_messages.hpp"
#include "sph3d/io/replace_file.hpp"
#include "sph3d/io/scene.hpp"
#include "sph3d/io/virtual_display.hpp"

VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace ostium::sph3d {
namespace {

constexpr double column = 430;  // pixels on the left for text
constexpr Colour ink = {0.10, 0.10, 0.12}, faint = {0.45, 0.45, 0.48};

double diameter(const Opening<3>& o) { return std::sqrt(4 * o.area / pi); }

std::string millimetres(double length) { return fmt::format("{:.3g} mm", 1e3 * length); }

/// Title, size of the vessel, one line per opening, then the notes as far as they fit.
void draw_column(vtkRenderer& overlay, const Lumen<3>& lumen, const PreviewOptions& options,
                 const std::string& size) {
  const double left = 28, width = column - left - 10;
  double y = options.height - 44;
  draw_text(overlay, Vec2(left, y), fitted(options.title, 26, width + 250), {.size = 26, .bold = true});
  draw_text(overlay, Vec2(left, y -= 38), size, {.size = 18, .colour = faint});
  y -= 20;
  const int rows = int(lumen.openings.size());
  const double step = std::clamp((y - 200) / std::max(rows, 1), 15.0, 30.0);
  const int font = step < 22 ? 14 : 19;
  for (int k = 0; k < rows && y > 60; ++k) {
    y -= step;
    const auto& o = lumen.openings[k];
    draw_rectangle(overlay, Vec2(left, y - 7), Vec2(left + 14, y + 7), opening_colour(k));
    draw_text(overlay, Vec2(left + 26, y), fitted(o.name, font, width - 150), {.size = font, .bold = true});
    draw_text(overlay, Vec2(left + width - 10, y), millimetres(diameter(o)),
              {.size = font, .right_aligned = true});
  }
  y -= 16;
  for (const auto& note : options.notes) {
    if ((y -= 23) < 90) break;
    draw_text(overlay, Vec2(left, y), fitted(note, 15, width), {.size = 15, .colour = ink});
  }
}

/// A bar of a round length, about a sixth of the picture.
void draw_scale(vtkRenderer& overlay, vtkRenderer& scene) {
  const double pixel_per_metre = [&] {
    const Vec2 a = pixel(scene, Vec3::Zero());
    double longest = 0;
    for (int d = 0; d < 3; ++d) longest += (pixel(scene, Vec3(Vec3::Unit(d))) - a).squaredNorm();
    return std::sqrt(longest / 2);  // orthographic: the squares of the three projected units add up to 2
  }();
  const double wanted = 190 / pixel_per_metre, power = std::pow(10, std::floor(std::log10(wanted)));
  const double length = (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1) * power;
  const Vec2 from(28, 40), to = from + Vec2(length * pixel_per_metre, 0);
  draw_line(overlay, from, to, ink, 3);
  for (const auto& end : {from, to}) draw_line(overlay, end - Vec2(0, 6), end + Vec2(0, 6), ink, 3);
  draw_text(overlay, to + Vec2(14, 0), millimetres(length), {.size = 18});
}

struct Label {
  Vec2 tip, at;
  std::string text;
  int opening;
  bool to_the_left;
};

/// Beside the arrow tips, on the side the arrow points to; then pushed apart until none covers another.
std::vector<Label> place_labels(vtkRenderer& scene, const Lumen<3>& lumen, const PreviewOptions& options,
                                int font) {
  std::vector<Label> labels;
  for (int k = 0; k < int(lumen.openings.size()); ++k) {
    const auto& o = lumen.openings[k];
    const Vec2 root = pixel(scene, o.centre), tip = pixel(scene, arrow_tip(lumen, o));
    const bool left = tip.x() < root.x() - 3;
    const Vec2 out = (tip - root).norm() > 1 ? Vec2((tip - root).normalized()) : Vec2(0, 1);
    labels.push_back({tip, tip + Vec2(left ? -14 : 14, 16 * out.y()),
                      fmt::format("{}  {}", o.name, millimetres(diameter(o))), k, left});
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.at.y() < b.at.y(); });
  const auto interval = [&](const Label& l) {
    const double w = text_width(l.text, font);
    return l.to_the_left ? std::pair(l.at.x() - w, l.at.x()) : std::pair(l.at.x(), l.at.x() + w);
  };
  const double step = font + 8;
  for (auto& l : labels) {
    const auto [a, b] = interval(l);
    l.at.x() += std::max(0.0, column - a) - std::max(0.0, b - options.width + 8);
  }
  for (int pass = 0; pass < 200; ++pass) {
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t j = i + 1; j < labels.size(); ++j) {
        const auto [a, b] = interval(labels[i]);
        const auto [c, d] = interval(labels[j]);
        const double overlap = step - std::abs(labels[j].at.y() - labels[i].at.y());
        if (b < c || d < a || overlap <= 0) continue;
        const double push = (labels[j].at.y() >= labels[i].at.y() ? 0.5 : -0.5) * (overlap + 0.1);
        labels[i].at.y() -= push, labels[j].at.y() += push;
      }
    for (auto& l : labels) l.at.y() = std::clamp(l.at.y(), 20.0, options.height - 20.0);
  }
  return labels;
}

void draw_labels(vtkRenderer& overlay, vtkRenderer& scene, const Lumen<3>& lumen,
                 const PreviewOptions& options) {
  const int font = lumen.openings.size() > 24 ? 14 : 20;
  for (const auto& l : place_labels(scene, lumen, options, font)) {
    const Colour colour = opening_colour(l.opening);
    draw_line(overlay, l.tip, l.at + Vec2(l.to_the_left ? 4 : -4, 0), colour, 1.5);
    draw_text(
        overlay, l.at, l.text,
        {.size = font, .colour = colour, .bold = true, .right_aligned = l.to_the_left, .on_white = true});
  }
}

void draw(vtkRenderWindow& window, const Lumen<3>& lumen, const PreviewOptions& options,
          const std::string& size) {
  vtkNew<vtkRenderer> scene, overlay;
  scene->SetBackground(1, 1, 1);
  scene->SetUseDepthPeeling(true);
  scene->SetMaximumNumberOfPeels(12), scene->SetOcclusionRatio(0);
  scene->SetUseFXAA(true);
  scene->SetViewport(column / options.width, 0, 1, 1);
  overlay->SetLayer(1), overlay->InteractiveOff();
  vtkNew<vtkRenderer> background;  // the column on the left has no scene behind it
  background->SetBackground(1, 1, 1);
  background->SetViewport(0, 0, column / options.width, 1);
  window.SetNumberOfLayers(2);
  window.AddRenderer(background), window.AddRenderer(scene), window.AddRenderer(overlay);
  add_vessel(*scene, lumen);
  aim_camera(*scene, lumen, Vec2(options.width - column, options.height), Vec2(0.13 * options.width, 60));
  window.Render();  // projections are known from here on
  draw_column(*overlay, lumen, options, size);
  draw_scale(*overlay, *scene);
  draw_labels(*overlay, *scene, lumen, options);
  window.Render();
}

void render(const Lumen<3>& lumen, const PreviewOptions& options, const std::string& size,
            const std::filesystem::path& png) {
  const VtkMessages messages;
  const VirtualDisplay display;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(options.width, options.height);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  draw(*window, lumen, options, size);
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  replace_file(png, [&](const std::filesystem::path& part) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(part.c_str());
    writer->SetInputConnection(image->GetOutputPort());
    writer->Write();
    return std::filesystem::exists(part);
  });
}

}  // namespace

template <>
void preview(const Lumen<3>& lumen, const PreviewOptions& options, const std::filesystem::path& png) {
  render(lumen, options,
         fmt::format("lumen {:.3g} mL, wall {:.3g} cm2, {} openings", 1e6 * lumen.volume,
                     1e4 * lumen.wall_area, lumen.openings.size()),
         png);
}

template <>
void preview(const Lumen<2>& lumen, const PreviewOptions& options, const std::filesystem::path& png) {
  render(sheet(lumen), options,
         fmt::format("plane lumen {:.3g} mm2, {} openings", 1e6 * lumen.volume, lumen.openings.size()), png);
}

}  // namespace ostium::sph3d
