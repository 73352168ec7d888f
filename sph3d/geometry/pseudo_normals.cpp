#include "sph3d/geometry/pseudo_normals.hpp"

#include "sph3d/geometry/edges.hpp"

namespace ostium::sph3d {
namespace {

double corner_angle(const Surface<3>& surface, int f, int corner) {
  const auto& t = surface.facets[f];
  const Vec3& a = surface.points[t[corner]];
  const Vec3 u = surface.points[t[(corner + 1) % 3]] - a, v = surface.points[t[(corner + 2) % 3]] - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::vector<Vec3> corner_normals(const Surface<3>& surface, const std::vector<Vec3>& of_facet) {
  std::vector<Vec3> normal(surface.points.size(), Vec3::Zero());
  for (int f = 0; f < int(surface.facets.size()); ++f)
    for (int corner = 0; corner < 3; ++corner)
      normal[surface.facets[f][corner]] += corner_angle(surface, f, corner) * of_facet[f];
  return normal;
}

}  // namespace

std::vector<Vec3> facet_normals(const Surface<3>& surface) {
  const int n = int(surface.facets.size());
  std::vector<Vec3> normal(n);
  std::vector<int> flat;
  const double tiny = 1e-15 * bounds(surface.points).extent().squaredNorm();
  for (int f = 0; f < n; ++f) {
    normal[f] = area_vector(surface, f);
    if (normal[f].norm() <= tiny) flat.push_back(f), normal[f].setZero();
    normal[f].normalize();
  }
  const auto beyond = flat.empty() ? std::vector<Triangle>{} : neighbours(surface.facets);
  for (int pass = 0; pass < 20 && !flat.empty(); ++pass) {
    std::vector<std::pair<int, Vec3>> found;
    for (int f : flat) {
      Vec3 sum = Vec3::Zero();
      for (int g : beyond[f])
        if (g >= 0) sum += normal[g];
      if (sum.norm() > 0.1) found.emplace_back(f, sum.normalized());
    }
    for (auto& [f, mean] : found) normal[f] = mean;
    std::erase_if(flat, [&](int f) { return normal[f].squaredNorm() > 0; });
  }
  return normal;
}

template <>
std::vector<FeatureNormals<3>> pseudo_normals<3>(const Surface<3>& surface) {
  const auto of_facet = facet_normals(surface);
  const auto of_corner = corner_normals(surface, of_facet);
  const auto beyond = neighbours(surface.facets);
  std::vector<FeatureNormals<3>> normals(surface.facets.size());
  for (int f = 0; f < int(normals.size()); ++f) {
    normals[f][0] = of_facet[f];
    for (int s = 0; s < 3; ++s) {
      const int g = beyond[f][s];
      normals[f][1 + s] = (g < 0 ? of_facet[f] : Vec3(of_facet[f] + of_facet[g])).normalized();
      normals[f][4 + s] = of_corner[surface.facets[f][s]].normalized();
    }
  }
  return normals;
}

template <>
std::vector<FeatureNormals<2>> pseudo_normals<2>(const Surface<2>& surface) {
  std::vector<Vec2> of_corner(surface.points.size(), Vec2::Zero());
  const int n = int(surface.facets.size());
  for (int f = 0; f < n; ++f)
    for (int v : surface.facets[f]) of_corner[v] += area_vector(surface, f).normalized();
  std::vector<FeatureNormals<2>> normals(n);
  for (int f = 0; f < n; ++f) {
    const auto [a, b] = surface.facets[f];
    normals[f] = {area_vector(surface, f).normalized(), of_corner[a].normalized(), of_corner[b].normalized()};
  }
  return normals;
}

}  // namespace ostium::sph3d
