/// The fluid equations once more, as plainly as they can be written: double precision, one structure per particle, one
/// heap-allocated neighbour list each with stored weights and directions. It is the reference the kernels are compared
/// with, in tests for their values and in the benchmark for their speed (the usual layout of particle codes).
#pragma once
#include <algorithm>
#include <vector>

#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/prepare.hpp"

namespace ostium::sph3d::plain {

template <int D>
struct Neighbourhood {
  std::vector<int> j;
  std::vector<double> W, dW_V, r;  // W V, W' V, distance
  std::vector<Vec<D>> e;           // from j to i
};

/// What the wall pushes with: the part of B grad S across it.
template <int D>
Vec<D> across_wall(const Mat<D>& B, const Vec<D>& wall) {
  if (wall.norm() == 0.0) return wall;
  const Vec<D> n = wall.normalized();
  return n.dot(B * wall) * n;
}

template <int D>
struct Particle {
  Vec<D> x = Vec<D>::Zero(), v = x, diss = x, prior = x, gradient = x, G = x, imbalance = x, wall = x,
         viscous = x;
  Mat<D> B = Mat<D>::Zero(), moment = B;
  double psi = 0, rate = 0, density = 0, k0 = 0, friction = 0, along = 0, wall_density = 1;

  /// With what the wall does not show of changes along it.
  Vec<D> completed(const Vec<D>& u) const {
    if (wall.norm() == 0.0) return u;
    const Vec<D> n = wall.normalized();
    return u + along * (u - n.dot(u) * n);
  }
};

template <int D>
struct Fluid {
  double c, nu, h, limiter, rest_volume;
  std::vector<Particle<D>> particles;
  std::vector<Neighbourhood<D>> neighbours;

  /// The particles of a state whose advection step has been prepared; lists from cells of one reach.
  Fluid(const Model<D>& model, const FluidState<D>& state) {
    c = model.options.sound_speed, nu = model.options.viscosity, h = model.kernel.h,
    limiter = model.options.limiter, rest_volume = model.rest_volume;
    for (std::size_t i = 0; i < state.places(); ++i) {
      const auto& own = state.clusters[i / 8];
      const std::size_t lane = i % 8;
      Particle<D> p;
      p.x = state.position[i];
      p.v = lane_vector<D>(own.v, lane);
      p.diss = lane_vector<D>(own.diss, lane);
      p.prior = lane_vector<D>(own.prior, lane);
      p.wall = lane_vector<D>(own.wall, lane);
      p.B = lane_matrix<D>(own.B, lane);
      p.psi = own.psi[lane], p.rate = own.rate[lane], p.friction = own.friction[lane],
      p.along = own.along[lane];
      particles.push_back(p);
    }
    find_neighbours(model, state);
  }

  /// density, gradient, moment, k0
  void sums() {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Particle<D>& p = particles[i];
      const Neighbourhood<D>& n = neighbours[i];
      p.density = self_, p.k0 = 0, p.gradient.setZero(), p.moment.setZero();
      for (std::size_t k = 0; k < n.j.size(); ++k) {
        p.density += n.W[k];
        p.k0 += n.dW_V[k];
        p.gradient += n.dW_V[k] * n.e[k];
        p.moment -= n.r[k] * n.dW_V[k] * n.e[k] * n.e[k].transpose();
      }
    }
  }

  /// G (with its wall part), viscous
  void corrected_sums() {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Particle<D>& p = particles[i];
      const Neighbourhood<D>& n = neighbours[i];
      p.wall_density = density_ratio(p);  // frozen with B
      p.G = 2.0 * p.wall_density * across_wall<D>(p.B, p.wall), p.viscous.setZero();
      Vec<D> gradient = Vec<D>::Zero();
      for (std::size_t k = 0; k < n.j.size(); ++k) {
        const Particle<D>& q = particles[n.j[k]];
        p.G += n.dW_V[k] * q.B * n.e[k];
        gradient += n.dW_V[k] * n.e[k];
        const double g = 0.5 * n.e[k].dot((p.B + q.B) * n.e[k]);
        p.viscous += 2.0 * nu * g * n.dW_V[k] / n.r[k] * (p.v - q.v);
      }
      p.imbalance = p.B * gradient + p.G;
      p.G -= p.completed(p.B * gradient) - p.B * gradient;
    }
  }

  void kick(double dt) {
    std::vector<Vec<D>> next(particles.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Particle<D>& p = particles[i];
      const Neighbourhood<D>& n = neighbours[i];
      const double P = c * c * p.psi / density_ratio(p);
      Vec<D> force = 2.0 * P * p.wall_density * across_wall<D>(p.B, p.wall), gradient = Vec<D>::Zero();
      double jump = 0;
      for (std::size_t k = 0; k < n.j.size(); ++k) {
        const Particle<D>& q = particles[n.j[k]];
        const double Q = c * c * q.psi / density_ratio(q);
        force += (P * q.B + Q * p.B) * n.e[k] * n.dW_V[k];
        gradient += (Q - P) * n.e[k] * n.dW_V[k];
        jump += (P - Q) * n.dW_V[k];
      }
      gradient = p.B * gradient;
      force += p.completed(gradient) - gradient;
      next[i] = (p.v + dt * (p.diss + p.prior - force)) / (1.0 + dt * p.friction);
      p.rate = (1.0 + p.psi) * jump / c;
    }
    for (std::size_t i = 0; i < particles.size(); ++i) particles[i].v = next[i];
  }

  void density(double dt, double weight) {
    std::vector<double> next(particles.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Particle<D>& p = particles[i];
      const Neighbourhood<D>& n = neighbours[i];
      double divergence = 0, into = 2.0 * p.v.dot(p.wall);
      p.diss.setZero();
      for (std::size_t k = 0; k < n.j.size(); ++k) {
        const double apart = (p.v - particles[n.j[k]].v).dot(n.e[k]), u = std::max(-apart, 0.0);
        divergence += p.completed(p.v - particles[n.j[k]].v).dot(n.e[k]) * n.dW_V[k];
        p.diss -= std::clamp(limiter * u - 2.0 * nu / n.r[k], 0.0, c) * u * n.dW_V[k] * n.e[k];
      }
      const double size = p.wall.norm();
      if (size > 0.0) {
        const double u = 2.0 * std::max(p.v.dot(p.wall), 0.0) / size;
        p.diss -= std::min(limiter * u, c) * u * p.wall;
      }
      p.rate += divergence / rest_volume + (1.0 + p.psi) * into;
      next[i] = p.psi + weight * dt * p.rate;
    }
    for (std::size_t i = 0; i < particles.size(); ++i) particles[i].psi = next[i];
  }

 private:
  double density_ratio(const Particle<D>& p) const { return (1.0 + p.psi) * rest_volume; }

  void find_neighbours(const Model<D>& model, const FluidState<D>& state) {
    const double reach = model.reach(), V = model.particle_volume;
    self_ = model.kernel.value(0.0) * V;
    Vec<D> low = Vec<D>::Constant(1e30);
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (state.filled[i]) low = low.cwiseMin(particles[i].x);
    constexpr std::int64_t wide = 4096;
    std::vector<std::pair<std::int64_t, int>> cells;
    const auto key = [&](const Vec<D>& x, const std::array<int, 3>& o) {
      std::int64_t k = 0;
      for (int d = D - 1; d >= 0; --d)
        k = k * wide + static_cast<std::int64_t>((x[d] - low[d]) / reach) + 1 + o[d];
      return k;
    };
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (state.filled[i]) cells.emplace_back(key(particles[i].x, {0, 0, 0}), static_cast<int>(i));
    std::sort(cells.begin(), cells.end());
    neighbours.resize(particles.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (!state.filled[i]) continue;
      for (int o = 0; o < (D == 3 ? 27 : 9); ++o) {
        const auto wanted = key(particles[i].x, {o % 3 - 1, o / 3 % 3 - 1, D == 3 ? o / 9 - 1 : 0});
        for (auto it = std::lower_bound(cells.begin(), cells.end(), std::pair<std::int64_t, int>{wanted, -1});
             it != cells.end() && it->first == wanted; ++it) {
          const Vec<D> apart = particles[i].x - particles[it->second].x;
          const double r = apart.norm();
          if (r >= reach || it->second == static_cast<int>(i)) continue;
          Neighbourhood<D>& n = neighbours[i];
          n.j.push_back(it->second);
          n.W.push_back(model.kernel.value(r) * V);
          n.dW_V.push_back(model.kernel.slope(r) * V);
          n.r.push_back(r);
          n.e.push_back(apart / r);
        }
      }
    }
  }

  double self_ = 0;
};

}  // namespace ostium::sph3d::plain
