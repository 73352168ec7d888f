/// Strains of a shell at one particle and the stresses of a law through the thickness, for numbers and for lanes.
///
///   x_a = G_a + u_a,  n_a = dN_a + d_a,  d = n - N     (subscript a: discrete derivative along tangent a)
///   membrane  E_ab = (G_a.u_b + u_a.G_b + u_a.u_b) / 2
///   bending   K_ab = (G_a.d_b + u_a.n_b + G_b.d_a + u_b.n_a) / 2
///   second    L_ab = (dN_a.d_b + d_a.n_b) / 2
///   shear     g_a  = u_a.n + G_a.d
///   E(chi) = E + chi K + chi^2 L                       Green strain at the distance chi from the mid-surface
///
/// All four vanish exactly under any rotation of the whole: they are differences of scalar products of the same discrete
/// vectors. In the orthonormal frame of the surface at chi the strain is Z E Z^T, Z = (I + chi curvature)^-1, and the
/// volume det(I + chi curvature): no term of the initial curvature is left out. Source: docs/theory/shell.md.
#pragma once
#include "sph3d/structure/plane_stress.hpp"

namespace ostium::sph3d {

/// Symmetric tensors over one or two tangents.
template <int T, class S>
struct Sym {
  S c[T * (T + 1) / 2];

  static constexpr int index(int a, int b) { return T == 1 ? 0 : a + b; }
  S& operator()(int a, int b) { return c[index(a, b)]; }
  const S& operator()(int a, int b) const { return c[index(a, b)]; }
};

/// Tractions of the tangents: derivatives of the energy per reference area by E, K, L and g.
template <int T, class S>
struct ShellStrains {
  Sym<T, S> membrane, bending, second;
  S shear[T];
};

/// I + chi curvature inverted, with its determinant.
template <int T, class S>
struct Shifter {
  S inverse[T][T], volume;
};

template <int T, class S>
[[gnu::always_inline]] inline Shifter<T, S> shifter(const S (&curvature)[T][T], const S& chi) {
  Shifter<T, S> z;
  if constexpr (T == 1) {
    z.volume = S(1.0) + chi * curvature[0][0];
    z.inverse[0][0] = S(1.0) / z.volume;
  } else {
    const S a = S(1.0) + chi * curvature[0][0], b = chi * curvature[0][1];
    const S c = chi * curvature[1][0], d = S(1.0) + chi * curvature[1][1];
    z.volume = a * d - b * c;
    const S over = S(1.0) / z.volume;
    z.inverse[0][0] = d * over, z.inverse[0][1] = -b * over;
    z.inverse[1][0] = -c * over, z.inverse[1][1] = a * over;
  }
  return z;
}

/// Z E Z^T with the order of the tangents of E in the columns of Z transposed: E^_cd = Z_ac E_ab Z_bd.
template <int T, class S>
[[gnu::always_inline]] inline Sym<T, S> to_frame(const Shifter<T, S>& z, const Sym<T, S>& E) {
  Sym<T, S> out;
  for (int c = 0; c < T; ++c)
    for (int d = c; d < T; ++d) {
      S sum(0.0);
      for (int a = 0; a < T; ++a)
        for (int b = 0; b < T; ++b) sum += z.inverse[c][a] * z.inverse[d][b] * E(a, b);
      out(c, d) = sum;
    }
  return out;
}

}  // namespace ostium::sph3d
