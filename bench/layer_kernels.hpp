/// Virtual layers (bench/layers.hpp) summed in lanes, as the engine sums its neighbours: what layers would cost it at best.
///
///   sums     what a cluster sees of the shell particles in its row, all their layers at once
///   impact   what is left to the acoustic steps: against a wall at rest everything else that they need is a sum once per
///            advection step, but the dissipation of each pair depends on the velocity
///
/// Coordinates are those of the clusters, over the reach.
#pragma once
#include "sph3d/fluid/cluster.hpp"

namespace ostium::bench {

struct alignas(32) ShellRecord {
  float x[3], n[3];
  float kV;         // of layer 0, see cluster.hpp
  float curvature;  // times the spacing
};

struct alignas(64) LayerSums {
  float filling[8], gradient[3][8], moment[6][8], friction[6][8];  // see WallSums
};

struct LayerConstants {
  float spacing = 0, closest = 0;  // of the layers; dp/4                  m
  float reach = 0;                 // m
  float density_factor = 0;        // see FluidConstants
  float most = 2;                  // limit of the extrapolation
  float limiter = 3, c = 0;        // of the dissipation; sound speed      m/s
};

struct alignas(32) Eight {
  float of[8];
};

struct LayerKernels {
  /// weights: of each pair, the sum over its layers of |W'| V, 1/m; distance of each particle to the wall, m
  void (*sums)(const sph3d::Cluster<3>&, const Eight& distance, sph3d::Rows, const ShellRecord*,
               const LayerConstants&, LayerSums&, Eight*);
  void (*impact)(const sph3d::Cluster<3>&, sph3d::Rows, const ShellRecord*, const Eight*,
                 const LayerConstants&, float (&acceleration)[3][8]);
};

/// For the same instruction set as fluid_kernels().
const LayerKernels& layer_kernels();

}  // namespace ostium::bench
