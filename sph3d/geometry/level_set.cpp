#include "sph3d/geometry/level_set.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {
namespace {

/// Distance to a piece and the arc length, from its start, of the nearest point.
struct Nearest {
  double distance, along;
};

Nearest nearest_on_line(const Piece& p, const Vec3& x) {
  const Vec3 d = p.end - p.start;
  const double t = std::clamp(d.dot(x - p.start) / d.squaredNorm(), 0.0, 1.0);
  return {(p.start + t * d - x).norm(), t * d.norm()};
}

Nearest nearest_on_arc(const Piece& p, const Vec3& x) {
  const Vec3 r = x - p.centre;
  double a = std::atan2(p.v.dot(r), p.u.dot(r));
  const double middle = 0.5 * p.angle;
  a = middle + std::remainder(a - middle, 2 * pi);  // the gap lies opposite to the middle of the arc
  a = std::clamp(a, 0.0, p.angle);
  const Vec3 on = p.arc_radius * (std::cos(a) * p.u + std::sin(a) * p.v);
  return {(r - on).norm(), a * p.arc_radius};
}

double distance(const TaperedTube& tube, double length, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity(), before = 0;
  for (const auto& piece : tube.pieces) {
    const auto n = piece.arc_radius > 0 ? nearest_on_arc(piece, x) : nearest_on_line(piece, x);
    const double t = (before + n.along) / length;
    least = std::min(least, n.distance - (tube.first + t * (tube.last - tube.first)));
    before += piece.length();
  }
  return least;
}

double smooth_min(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4 * k);
}

}  // namespace

double Piece::length() const { return arc_radius > 0 ? arc_radius * angle : (end - start).norm(); }

Piece line(const Vec3& start, const Vec3& end) {
  return {.start = start, .end = end, .centre = Vec3::Zero(), .u = Vec3::Zero(), .v = Vec3::Zero()};
}

Piece arc(const Vec3& centre, const Vec3& u, const Vec3& v, double radius, double angle) {
  return {.start = Vec3::Zero(),
          .end = Vec3::Zero(),
          .centre = centre,
          .u = u,
          .v = v,
          .arc_radius = radius,
          .angle = angle};
}

LevelSet blend(std::vector<TaperedTube> tubes, double fillet) {
  std::vector<double> length;
  for (const auto& tube : tubes) {
    length.push_back(0);
    for (const auto& piece : tube.pieces) length.back() += piece.length();
  }
  return [tubes = std::move(tubes), length = std::move(length), fillet](const Vec3& x) {
    double f = distance(tubes[0], length[0], x);
    for (std::size_t t = 1; t < tubes.size(); ++t)
      f = smooth_min(f, distance(tubes[t], length[t], x), fillet);
    return f;
  };
}

}  // namespace ostium::sph3d
