#include "sph3d/shell/linear_shell.hpp"

#include "sph3d/shell/through_thickness.hpp"

namespace ostium::sph3d {

namespace {

/// The tangents of the reference and their normals.
template <int D>
struct Reference {
  static constexpr int T = D - 1;
  const ShellReference<D>& r;
  std::size_t lane;
  Vec<D> G[T], dN[T], N;

  Reference(const ShellModel<D>& model, std::size_t a) : r(model.reference[a / 8]), lane(a % 8) {
    N = at<D>(r.N, lane);
    for (int t = 0; t < T; ++t) G[t] = at<D>(r.G[t], lane), dN[t] = at<D>(r.dN[t], lane);
  }
};

Sym3<double> hooke(const SaintVenantKirchhoff& law, Sym3<double> E) {
  E.zz = -law.thinning() * (E.xx + E.yy);
  Sym3<double> S = law.stress(E);
  S.zz = 0.0;
  return S;
}

/// Every row of the gradients by its weights: what the neighbours feel of them.
template <int D>
struct Pull {
  Vec<D> P[D - 1], M[D - 1], H;
};

}  // namespace

template <int D>
Sym3<double> hooke_at(const ShellModel<D>& model, const ShellStrains<D - 1, double>& strain,
                      const Shifter<D - 1, double>& z, std::size_t a, double chi) {
  const SaintVenantKirchhoff law(moduli(model.options.material));
  return model.reference[a / 8].stiffness[a % 8] * hooke(law, strain_at<D - 1, double>(strain, z, chi));
}

template <int D>
LinearShell<D>::LinearShell(const ShellModel<D>& model)
    : model_(model), law_(moduli(model.options.material)) {}

template <int D>
ShellMeasure<D> LinearShell<D>::strain(const ShellField<D>& x, std::size_t a) const {
  constexpr int T = D - 1;
  const Reference<D> o(model_, a);
  ShellVector<D> dx[T];
  ShellMeasure<D> e{no_strains<T, double>(), -o.r.hourglass_turn[o.lane] * x[a].d};
  for (auto k = model_.row_begin[a]; k < model_.row_begin[a + 1]; ++k) {
    const auto& b = x[std::size_t(model_.neighbour[k])];
    const auto& weight = model_.forward[k];
    const Vec<D> u = b.u - x[a].u, d = b.d - x[a].d;
    for (int t = 0; t < T; ++t) dx[t].u += weight.gradient[t] * u, dx[t].d += weight.gradient[t] * d;
    e.zigzag += weight.hourglass * u;
  }
  for (int i = 0; i < T; ++i) {
    for (int j = i; j < T; ++j) {
      e.sheet.membrane(i, j) = 0.5 * (o.G[i].dot(dx[j].u) + o.G[j].dot(dx[i].u));
      e.sheet.bending(i, j) =
          0.5 * (o.G[i].dot(dx[j].d) + dx[i].u.dot(o.dN[j]) + o.G[j].dot(dx[i].d) + dx[j].u.dot(o.dN[i]));
      e.sheet.second(i, j) = 0.5 * (o.dN[i].dot(dx[j].d) + o.dN[j].dot(dx[i].d));
    }
    e.sheet.shear[i] = dx[i].u.dot(o.N) + o.G[i].dot(x[a].d);
  }
  return e;
}

template <int D>
ShellMeasure<D> LinearShell<D>::stress(const ShellMeasure<D>& e, std::size_t a) const {
  constexpr int T = D - 1;
  const Reference<D> o(model_, a);
  double curvature[T][T];
  for (int i = 0; i < T; ++i)
    for (int j = 0; j < T; ++j) curvature[i][j] = o.r.curvature[i][j][o.lane];
  const double factor = o.r.stiffness[o.lane], within = o.r.hourglass_stiffness[0][o.lane],
               across = o.r.hourglass_stiffness[1][o.lane] - within;
  ShellMeasure<D> s{no_strains<T, double>(), within * e.zigzag + across * e.zigzag.dot(o.N) * o.N};
  through_thickness<T, double>(curvature, o.r.thickness[o.lane], model_.options.gauss_points,
                               [&](const Shifter<T, double>& z, double chi, double share) {
                                 const auto S = factor * hooke(law_, strain_at<T, double>(e.sheet, z, chi));
                                 add_tractions<T, double>(S, z, chi, share, s.sheet);
                               });
  return s;
}

template <int D>
ShellField<D> LinearShell<D>::balance(const std::vector<ShellMeasure<D>>& s) const {
  constexpr int T = D - 1;
  const auto n = std::int64_t(model_.count());
  std::vector<Pull<D>> pull(s.size());
  ShellField<D> f(s.size());
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (std::int64_t a = 0; a < n; ++a) {
      const Reference<D> o(model_, std::size_t(a));
      const double area = o.r.area[o.lane];
      auto& [P, M, H] = pull[a];
      H = area * s[a].zigzag;
      f[a] = {-o.r.hourglass_sum[o.lane] * H, -o.r.hourglass_turn[o.lane] * H};
      for (int i = 0; i < T; ++i) {
        const double q = area * s[a].sheet.shear[i], sum = o.r.sum[i][o.lane];
        P[i] = q * o.N, M[i] = Vec<D>::Zero();
        for (int j = 0; j < T; ++j) {
          P[i] += area * (s[a].sheet.membrane(i, j) * o.G[j] + s[a].sheet.bending(i, j) * o.dN[j]);
          M[i] += area * (s[a].sheet.bending(i, j) * o.G[j] + s[a].sheet.second(i, j) * o.dN[j]);
        }
        f[a].u -= sum * P[i], f[a].d += q * o.G[i] - sum * M[i];
      }
    }
#pragma omp for schedule(static)
    for (std::int64_t a = 0; a < n; ++a) {
      for (auto k = model_.row_begin[a]; k < model_.row_begin[a + 1]; ++k) {
        const auto& weight = model_.backward[k];
        const auto& [P, M, H] = pull[std::size_t(model_.neighbour[k])];
        f[a].u += weight.hourglass * H;
        for (int i = 0; i < T; ++i) f[a].u += weight.gradient[i] * P[i], f[a].d += weight.gradient[i] * M[i];
      }
      hold(f[a], std::size_t(a));
    }
  }
  return f;
}

template <int D>
ShellField<D> LinearShell<D>::stiffness(const ShellField<D>& x) const {
  std::vector<ShellMeasure<D>> s(x.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < x.size(); ++a) s[a] = stress(strain(x, a), a);
  return balance(s);
}

template <int D>
void LinearShell<D>::hold(ShellVector<D>& x, std::size_t a) const {
  const Reference<D> o(model_, a);
  const Vec<D> axis = at<D>(o.r.axis, o.lane);
  x.d -= x.d.dot(o.N) * o.N;
  x.u = o.r.keep[0][o.lane] * x.u + o.r.keep_axis[0][o.lane] * x.u.dot(axis) * axis;
  x.d = o.r.keep[1][o.lane] * x.d + o.r.keep_axis[1][o.lane] * x.d.dot(axis) * axis;
}

template <int D>
ShellVector<D> LinearShell<D>::weight(std::size_t a) const {
  const Reference<D> o(model_, a);
  const Moduli m = law_.moduli();
  const double t = o.r.thickness[o.lane], dp = model_.options.spacing,
               scale = o.r.stiffness[o.lane] * o.r.area[o.lane] * t;
  const double extension = m.plate() / (dp * dp);
  return {Vec<D>::Constant(scale * extension),
          Vec<D>::Constant(scale * (5.0 / 6.0 * m.mu() + extension * t * t / 12.0))};
}

template class LinearShell<2>;
template class LinearShell<3>;
template Sym3<double> hooke_at(const ShellModel<2>&, const ShellStrains<1, double>&,
                               const Shifter<1, double>&, std::size_t, double);
template Sym3<double> hooke_at(const ShellModel<3>&, const ShellStrains<2, double>&,
                               const Shifter<2, double>&, std::size_t, double);

}  // namespace ostium::sph3d
