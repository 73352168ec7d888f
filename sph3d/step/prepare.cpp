#include "sph3d/step/prepare.hpp"

#include <algorithm>

#include "sph3d/step/lane_access.hpp"

namespace ostium::sph3d {

namespace {

/// Inverse of the moment matrix, led back to the identity where the support is too one-sided to invert.
template <int D>
Mat<D> correction(const Mat<D>& moment) {
  constexpr double weakest = 0.5;
  const double det = moment.determinant();
  if (!(det > 1e-6)) return Mat<D>::Identity();
  const double weight = det / (det + std::max(weakest - det, 0.0));
  return weight * moment.inverse() + (1.0 - weight) * Mat<D>::Identity();
}

template <int D>
Mat<D> outside_moment(const HalfSpace<D>& space, double s, const Vec<D>& normal) {
  const Mat<D> nn = normal * normal.transpose();
  return space.moment_n(s) * nn + space.moment_t(s) * (Mat<D>::Identity() - nn);
}

template <int D>
Mat<D> open_moment(const Model<D>& model, const Duct<D>& duct, const Vec<D>& x, double wall_filling) {
  return (1.0 - wall_filling) * outside_moment(model.half_space, duct.depth(x), duct.opening().normal);
}

}  // namespace

template <int D>
void correct_density(const Model<D>& model, FluidState<D>& fluid, const Workspace<D>& work, double dt) {
  const double theta = model.options.density_relaxation;
  for_clusters(fluid.clusters.size(), [&](std::size_t c) {
    Cluster<D>& own = fluid.clusters[c];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * c + lane;
      own.source[lane] = 0;
      if (!fluid.filled[i]) continue;
      if (const int k = work.duct_of[i]; k >= 0)
        if (model.roles[k].flow_driven || model.ducts[k].depth(fluid.position[i]) < model.reach()) continue;
      const double sum =
          work.sums[c].density[lane] + work.around[c].filling[lane] + work.around[c].open_filling[lane];
      own.source[lane] = static_cast<float>(theta / dt * (sum / model.number_density - 1.0 - own.psi[lane]));
    }
  });
}

template <int D>
void correct_gradients(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work) {
  for_clusters(fluid.clusters.size(), [&](std::size_t c) {
    Cluster<D>& own = fluid.clusters[c];
    ClusterSurroundings<D>& around = work.around[c];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * c + lane;
      Mat<D> moment = lane_matrix<D>(work.sums[c].moment, lane);
      const Vec<D> flux = lane_vector<D>(own.wall, lane);
      const bool near_wall = around.filling[lane] > 0.0f && flux.squaredNorm() > 0.0;
      const Vec<D> n = near_wall ? Vec<D>(flux.normalized()) : Vec<D>(Vec<D>::Zero());
      const double s = near_wall ? model.half_space.distance(around.filling[lane]) : 0.0;
      if (near_wall) moment += outside_moment(model.half_space, s, n);
      if (around.open_filling[lane] > 0.0f)
        moment += open_moment(model, model.ducts[work.duct_of[i]], fluid.position[i], around.filling[lane]);
      const Mat<D> B = correction(moment);
      own.friction[lane] = 0;
      if (near_wall) {
        const double nBn = n.dot(B * n);
        const double rate =
            model.half_space.friction_n(s) * nBn + model.half_space.friction_t(s) * (B.trace() - nBn);
        own.friction[lane] = static_cast<float>(model.options.viscosity * rate);
      }
      for (int a = 0, k = 0; a < D; ++a)
        for (int b = a; b < D; ++b, ++k) work.matrix[i].b[k] = own.B[k][lane] = static_cast<float>(B(a, b));
    }
  });
}

namespace {

/// The side of the kernel support that the particles themselves cover: sum (B_i + B_j) grad W V + 2 B_i grad
/// S.
template <int D>
Vec<D> seen(const Cluster<D>& own, const ClusterSums<D>& sums, std::size_t lane) {
  return lane_matrix<D>(own.B, lane) * lane_vector<D>(sums.gradient, lane) + lane_vector<D>(own.G, lane);
}

/// The shape of the profile at each particle, divided by its mean over the duct in a smooth window: Q = sum V v_n w / int w.
template <int D>
void prepare_profile(const Model<D>& model, const FluidState<D>& fluid, Zone<D>& zone, std::size_t k) {
  const Duct<D>& duct = model.ducts[k];
  double carried = 0;
  for (auto& member : zone.members) {
    member.drive = static_cast<float>(model.shapes[k](fluid.position[member.index]));
    const double u = member.depth / duct.length();
    if (u > 0.0 && u < 1.0) carried += member.drive * (1.0 - std::cos(2.0 * pi * u));
  }
  const double mean = carried * fluid.volume / (duct.length() * duct.opening().area);
  if (mean < 0.5) return;  // hardly a particle there
  for (auto& member : zone.members) member.drive /= static_cast<float>(mean);
}

template <int D>
void prepare_zones(const Model<D>& model, const FluidState<D>& fluid, Workspace<D>& work) {
  for (std::size_t k = 0; k < work.zones.size(); ++k) {
    const Vec<D>& normal = model.ducts[k].opening().normal;
    if (model.roles[k].flow_driven) prepare_profile(model, fluid, work.zones[k], k);
    for (auto& member : work.zones[k].members) {
      const std::size_t c = member.index / 8, lane = member.index % 8;
      if (!model.roles[k].flow_driven && member.depth < model.reach())
        member.drive = static_cast<float>(-seen(fluid.clusters[c], work.sums[c], lane).dot(normal));
      // along the duct the layers arrive in phase with the flow, not with the outer face: no shift that way
      // near it
      const double free = model.roles[k].flow_driven
                              ? 0.0
                              : std::clamp((member.depth - model.reach()) / model.options.dp, 0.0, 1.0);
      Vec<D> shift = lane_vector<D>(work.around[c].shift, lane);
      shift -= (1.0 - free) * shift.dot(normal) * normal;
      lane_assign<D>(work.around[c].shift, lane, shift);
    }
  }
}

}  // namespace

template <int D>
void prepare_forces(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work) {
  const FluidConstants constants = constants_of(model);
  for_batches(fluid.clusters.size(), [&](std::size_t begin, std::size_t end) {
    fluid_kernels<D>().corrected_sums(begin, end, fluid.clusters.data(), work.sums.data(), work.rows.data(),
                                      work.place.data(), work.velocity.data(), work.matrix.data(), constants);
  });
  const double zeta_h2 = model.options.shift * model.kernel.h * model.kernel.h;
  for_clusters(fluid.clusters.size(), [&](std::size_t c) {
    Cluster<D>& own = fluid.clusters[c];
    ClusterSurroundings<D>& around = work.around[c];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const Mat<D> B = lane_matrix<D>(own.B, lane);
      const Vec<D> G = lane_vector<D>(own.G, lane) + 2.0 * B * lane_vector<D>(own.wall, lane);
      lane_assign<D>(own.G, lane, G);
      const Vec<D> viscous = lane_vector<D>(work.sums[c].viscous, lane);
      const bool filled = fluid.filled[8 * c + lane];
      const Vec<D> gravity = filled ? model.options.gravity : Vec<D>(Vec<D>::Zero());
      lane_assign<D>(own.prior, lane, Vec<D>(viscous + gravity));
      const Vec<D> open = lane_vector<D>(around.open_flux, lane);
      lane_assign<D>(around.shift, lane, Vec<D>(-zeta_h2 * (seen(own, work.sums[c], lane) + 2.0 * B * open)));
    }
  });
  prepare_zones(model, fluid, work);
}

#define OSTIUM_INSTANTIATE(D)                                                                  \
  template void correct_density(const Model<D>&, FluidState<D>&, const Workspace<D>&, double); \
  template void correct_gradients(const Model<D>&, FluidState<D>&, Workspace<D>&);             \
  template void prepare_forces(const Model<D>&, FluidState<D>&, Workspace<D>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
