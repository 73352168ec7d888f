#include <cmath>

#include "bench/workload.hpp"
#include "sph3d/step/prepare.hpp"

namespace ostium::bench {

using namespace sph3d;

Prepared::Prepared(const Vessel<3>& vessel) : model(vessel.model()), fluid(vessel.state().fluid) {
  for (std::size_t i = 0; i < fluid.places(); ++i) {
    if (!fluid.filled[i]) continue;
    const Vec3& x = fluid.position[i];
    fluid.velocity(i, Vec3(std::sin(900 * x[0]), std::sin(700 * x[1]), std::cos(800 * x[2])));
    fluid.psi(i) += static_cast<float>(2e-3 * std::cos(1200 * x.sum()));
  }
  PhaseSeconds seconds;
  prepare_step(model, fluid, work, 1e-4, still, seconds);
}

void Prepared::sums(const FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end) {
  kernels.sums(begin, end, fluid.clusters.data(), work.sums.data(), work.rows.data(), work.place.data(),
               constants_of(model));
}

void Prepared::corrections(const FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end) {
  kernels.corrections(begin, end, fluid.clusters.data(), work.sums.data(), work.around.data(),
                      work.matrix.data(), work.place.data(), constants_of(model), still);
}

void Prepared::corrected_sums(const FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end) {
  kernels.corrected_sums(begin, end, fluid.clusters.data(), work.sums.data(), work.rows.data(),
                         work.place.data(), work.velocity.data(), work.matrix.data(), constants_of(model));
}

void Prepared::kick(const FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end) {
  kernels.kick(begin, end, fluid.clusters.data(), work.rows.data(), work.place.data(), work.velocity.data(),
               nullptr, constants_of(model), still);
}

void Prepared::density(const FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end) {
  kernels.density(begin, end, fluid.clusters.data(), work.rows.data(), work.place.data(),
                  work.velocity.data(), nullptr, constants_of(model), still, 1.0f);
}

void Prepared::show_pressures() {
  const float c2 = constants_of(model).c2, kV = constants_of(model).kV;
  for (std::size_t i = 0; i < fluid.places(); ++i) work.place[i].w = kV * fluid.psi(i) * c2;
}

}  // namespace ostium::bench
