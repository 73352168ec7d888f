#include "sph3d/shell/stable_step.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

template <int D>
double plate_modulus(const ShellModel<D>& model, std::size_t a) {
  return model.reference[a / 8].stiffness[a % 8] * moduli(model.options.material).plate();
}

/// Largest tension of the pre-stress: a stretched wall is stiffer, as a string is.
template <int D>
double tension(const ShellModel<D>& model, std::size_t a) {
  if (model.prestress.empty()) return 0.0;
  const auto& n = model.prestress.blocks[a / 8].traction;
  const std::size_t lane = a % 8;
  double largest = n[0][lane];
  if constexpr (D == 3)
    largest = 0.5 * (n[0][lane] + n[2][lane]) + std::hypot(0.5 * (n[0][lane] - n[2][lane]), n[1][lane]);
  return std::max(largest, 0.0) / model.cloud.thickness[a];
}

template <int D>
double plate_speed(const ShellModel<D>& model, std::size_t a) {
  return std::sqrt((plate_modulus(model, a) + tension(model, a)) / model.options.density);
}

template <int D>
double material_bound(const ShellModel<D>& model, std::size_t a) {
  const double h = model.kernel.h, nu = moduli(model.options.material).nu;
  const double h2_g = h * h / (12.0 * model.gyration2(a));
  const double mindlin = 2.0 + pi * pi / 12.0 * (1.0 - nu) * (1.0 + 1.5 * h2_g);
  return h / plate_speed(model, a) / std::sqrt(std::max(1.0, mindlin));
}

template <int D>
double length(const double (&field)[D][8], std::size_t lane) {
  double sum = 0.0;
  for (int d = 0; d < D; ++d) sum += field[d][lane] * field[d][lane];
  return std::sqrt(sum);
}

template <int D>
double motion_bound(const ShellModel<D>& model, const ShellState<D>& state, const ShellWorkspace<D>& work,
                    std::size_t a) {
  const double h = model.kernel.h, tiny = 1e-300;
  const auto& block = state.blocks[a / 8];
  const auto& force = work.force[a / 8];
  const std::size_t lane = a % 8;
  return std::min({h / (plate_speed(model, a) + length<D>(block.v, lane)),
                   std::sqrt(h / (length<D>(force.force, lane) + tiny)),
                   1.0 / (length<D>(block.w, lane) + tiny),
                   1.0 / std::sqrt(length<D>(force.moment, lane) + tiny)});
}

}  // namespace

template <int D>
double stable_step(const ShellModel<D>& model) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t a = 0; a < model.count(); ++a) least = std::min(least, material_bound(model, a));
  return model.options.cfl * least;
}

template <int D>
double stable_step(const ShellModel<D>& model, const ShellState<D>& state, const ShellWorkspace<D>& work) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t a = 0; a < model.count(); ++a)
    least = std::min({least, material_bound(model, a), motion_bound(model, state, work, a)});
  return model.options.cfl * least;
}

template double stable_step(const ShellModel<2>&);
template double stable_step(const ShellModel<3>&);
template double stable_step(const ShellModel<2>&, const ShellState<2>&, const ShellWorkspace<2>&);
template double stable_step(const ShellModel<3>&, const ShellState<3>&, const ShellWorkspace<3>&);

}  // namespace ostium::sph3d
