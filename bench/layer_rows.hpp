/// The clusters of a fluid that are near a tube's wall, with that wall as virtual layers.
#pragma once
#include "bench/layer_kernels.hpp"
#include "bench/layers.hpp"
#include "bench/workload.hpp"

namespace ostium::bench {

class LayerRows {
 public:
  /// The tube along x_3 that the workload makes; clusters: those near its wall.
  LayerRows(const Prepared& prepared, std::vector<std::size_t> clusters, double spacing);

  void find();    // shell particles within reach of each cluster; once per advection step
  void sums();    // likewise
  void impact();  // once per acoustic step

  double mean_length() const;  // shell particles per cluster
  /// Largest difference of the filling from that of Layers, over all clusters.
  double error() const;

 private:
  void sort(const std::vector<Shell<3>>& shells);
  void set_records();

  const Prepared& from_;
  std::vector<std::size_t> clusters_;
  std::vector<Eight> distance_;
  LayerConstants constants_;
  // the shell in an order of memory like the fluid's, eight by eight, with the tree of boxes above it
  std::vector<Shell<3>> shells_;
  std::vector<ShellRecord> records_;
  std::vector<sph3d::Points<3>> points_;
  std::vector<std::vector<sph3d::Boxes<3>>> levels_;
  // per cluster
  std::vector<std::int32_t> rows_, begin_;
  std::vector<Eight> weights_;
  std::vector<LayerSums> sums_;
};

}  // namespace ostium::bench
