#include "sph3d/shell/cloud.hpp"

#include "core/error.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {

namespace {

template <class T>
void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  if (values.empty()) return;
  std::vector<T> sorted;
  sorted.reserve(values.size());
  for (auto i : order) sorted.push_back(values[i]);
  values = std::move(sorted);
}

template <class T>
void check_length(const std::vector<T>& values, std::size_t n, const char* name, bool optional) {
  if (values.size() != n && !(optional && values.empty()))
    user_error("the shell has {} particles but {} of {}; every particle needs one", n, values.size(), name);
}

void check_positive(const std::vector<double>& values, const char* name) {
  for (std::size_t a = 0; a < values.size(); ++a)
    if (!(values[a] > 0.0))
      user_error("{} of shell particle {} is {}; it has to be positive", name, a, values[a]);
}

}  // namespace

template <int D>
ShellCloud<D> in_memory_order(const ShellCloud<D>& cloud) {
  const auto order = bisection_order<D>(cloud.position);
  ShellCloud<D> sorted = cloud;
  permute(sorted.position, order);
  permute(sorted.normal, order);
  permute(sorted.area, order);
  permute(sorted.thickness, order);
  permute(sorted.stiffness, order);
  permute(sorted.support, order);
  permute(sorted.axis, order);
  permute(sorted.circumference, order);
  return sorted;
}

template <int D>
void check(const ShellCloud<D>& cloud) {
  const std::size_t n = cloud.count();
  if (n == 0) user_error("the shell has no particles; the surface may be smaller than the spacing");
  check_length(cloud.normal, n, "normals", false);
  check_length(cloud.area, n, "areas", false);
  check_length(cloud.thickness, n, "thicknesses", false);
  check_length(cloud.stiffness, n, "stiffness factors", true);
  check_length(cloud.support, n, "supports", true);
  check_length(cloud.axis, n, "axes", true);
  check_length(cloud.circumference, n, "circumferences", true);
  check_positive(cloud.area, "the area");
  check_positive(cloud.thickness, "the thickness");
  check_positive(cloud.stiffness, "the stiffness factor");
  for (std::size_t a = 0; a < n; ++a)
    if (std::abs(cloud.normal[a].norm() - 1.0) > 1e-8)
      user_error("the normal of shell particle {} has the length {}; it has to be 1", a,
                 cloud.normal[a].norm());
}

template ShellCloud<2> in_memory_order(const ShellCloud<2>&);
template ShellCloud<3> in_memory_order(const ShellCloud<3>&);
template void check(const ShellCloud<2>&);
template void check(const ShellCloud<3>&);

}  // namespace ostium::sph3d
