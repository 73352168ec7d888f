/// A shell in small motion about its reference, where it is free of stress: Hooke's law, everything to first order.
///
///   e = B x,   s = C e,   K x = B^T C B x            the zigzag and its force are a strain and a stress like the others
///
///   symbol   meaning                                                                         unit
///   x        of each particle: displacement u of the mid-surface, turn d = n - N of the normal     m, -
///   e        strains of strain.hpp to first order; zigzag h                                   -, 1/m, 1/m2, -; m
///   s        derivatives of the energy per reference area by them                             N/m, N, N m, N/m; Pa
///   f        forces on u, moments on d; zero where supports hold                              N, N m
///
/// B and its transpose are those of the kernels at u = d = 0, so that inner forces there are B^T s to rounding. Constants of
/// the material at small strain; no damping, no tissue around. Plain and slow. Source: docs/theory/shell.md, section "Balance".
#pragma once
#include "sph3d/shell/model.hpp"

namespace ostium::sph3d {

/// What a particle has two vectors of: displacement and turn, or force and moment.
template <int D>
struct ShellVector {
  Vec<D> u = Vec<D>::Zero(), d = Vec<D>::Zero();

  double dot(const ShellVector& b) const { return u.dot(b.u) + d.dot(b.d); }
};
template <int D>
using ShellField = std::vector<ShellVector<D>>;

/// Strains with the zigzag, or stresses with its force.
template <int D>
struct ShellMeasure {
  ShellStrains<D - 1, double> sheet;
  Vec<D> zigzag;
};

template <int D>
class LinearShell {
 public:
  explicit LinearShell(const ShellModel<D>& model);

  ShellMeasure<D> strain(const ShellField<D>& x, std::size_t a) const;
  ShellMeasure<D> stress(const ShellMeasure<D>& e, std::size_t a) const;
  /// B^T s: what the stresses resist with.
  ShellField<D> balance(const std::vector<ShellMeasure<D>>& s) const;
  /// K x
  ShellField<D> stiffness(const ShellField<D>& x) const;
  /// The part that supports leave free; of d and of moments what is perpendicular to N.
  void hold(ShellVector<D>& x, std::size_t a) const;
  /// The size of K for displacements and for turns of one particle, N/m and N m.
  ShellVector<D> weight(std::size_t a) const;

 private:
  const ShellModel<D>& model_;
  SaintVenantKirchhoff law_;
};

/// Stress of Hooke's law at chi, in the orthonormal frame there, times the factor on the stiffness.
template <int D>
Sym3<double> hooke_at(const ShellModel<D>& model, const ShellStrains<D - 1, double>& strain,
                      const Shifter<D - 1, double>& z, std::size_t a, double chi);

}  // namespace ostium::sph3d
