/// What a particle misses when a half-space is cut off its kernel support: integrals over the far side of a
/// plane.
///
///   With s the distance to the plane, n its normal (out of the fluid), e the unit vector to the particle, r
///   the distance and the integrals taken over the half-space beyond the plane:
///
///   filling(s)       S   = int W dV                            -        1/2 at s = 0
///   flux(s)          w   = int W over the plane = -dS/ds        1/m      int grad W dV = n w
///   moment_n(s)      m_n = int r |W'| (e.n)^2 dV                -        } moment matrix: m_n n n^T + m_t (I
///   - n n^T) moment_t(s)      m_t = int r |W'| (1 - (e.n)^2)/(D-1) dV    -        } friction_n(s)    f_n =
///   int 2 lambda |W'|/r (e.n)^2 dV       1/m^2    } deceleration by the wall: nu f (v - v_wall),
///   friction_t(s)    f_t = same, tangential                     1/m^2    } f = f_n n.Bn + f_t (tr B - n.Bn)
///
///   lambda = 1 + min(depth / max(s, dp/4), most): the velocity continues linearly through the wall, the ratio
///   capped.
///
/// All are tabulated over s in [0, 2h]; distance(S) inverts the filling. Negative s (a particle that has
/// slipped through) follows from S(-s) = 1 - S(s); moments and friction are those of s = 0 there. Source:
/// docs/theory/walls.md, sections "Half-space integrals" and "Friction".
#pragma once
#include <array>

#include "sph3d/fluid/wendland.hpp"

namespace ostium::sph3d {

template <int D>
class HalfSpace {
 public:
  /// `most` caps the ratio in lambda; dp is the particle spacing, m.
  HalfSpace(const Wendland<D>& kernel, double dp, double most = 4.0);

  double filling(double s) const;
  double flux(double s) const;
  double moment_n(double s) const { return at(moment_n_, s); }
  double moment_t(double s) const { return at(moment_t_, s); }
  double friction_n(double s) const { return at(friction_n_, s); }
  double friction_t(double s) const { return at(friction_t_, s); }

  /// The distance at which the filling is S; 2h for S <= 0, negative for S > 1/2.
  double distance(double S) const;

  /// Moments (-) and friction (1/m2) at the distance where the filling is S, straight from a table; those of the wall itself
  /// for S > 1/2.
  struct Share {
    float moment_n, moment_t, friction_n, friction_t;
  };
  Share share(float S) const;

 private:
  static constexpr int n = 520;  // a node at dp/4, where friction has a kink, for h = 1.3 dp
  using Table = std::array<double, n + 1>;

  double at(const Table& table, double s) const;

  double reach_;
  Table filling_{}, flux_{}, moment_n_{}, moment_t_{}, friction_n_{}, friction_t_{};
  /// Over the fourth root of the filling, which is nearly linear in the distance; a node at that kink as well.
  static constexpr int shares = 2048;
  std::array<Share, shares + 2> share_{};
  float shares_per_root_ = 0;
};

extern template class HalfSpace<2>;
extern template class HalfSpace<3>;

}  // namespace ostium::sph3d
