#include "network/tableau.hpp"

namespace ostium::network {

namespace {

constexpr double gamma_3 = 1767732205903. / 4055673282236.;

Tableau with_error(Tableau t, const std::array<double, Tableau::most>& lower) {
  for (int j = 0; j < t.stages; ++j) t.error[j] = t.a[t.stages - 1][j] - lower[j];
  return t;
}

}  // namespace

const Tableau& third_order() {
  static const Tableau t =
      with_error({.stages = 4,
                  .order = 3,
                  .gamma = gamma_3,
                  .a = {{{},
                         {gamma_3, gamma_3},
                         {2746238789719. / 10658868560708., -640167445237. / 6845629431997., gamma_3},
                         {1471266399579. / 7840856788654., -4482444167858. / 7529755066697.,
                          11266239266428. / 11593286722821., gamma_3}}},
                  .c = {0, 2 * gamma_3, 0.6, 1},
                  .error = {},
                  .nodes = {0, 2, 1, 3},
                  .probe = 1},
                 {2756255671327. / 12835298489170., -10771552573575. / 22201958757719.,
                  9247589265047. / 10645013368117., 2193209047091. / 5459859503100.});
  return t;
}

const Tableau& fourth_order() {
  static const Tableau t =
      with_error({.stages = 6,
                  .order = 4,
                  .gamma = 0.25,
                  .a = {{{},
                         {0.25, 0.25},
                         {8611. / 62500., -1743. / 31250., 0.25},
                         {5012029. / 34652500., -654441. / 2922500., 174375. / 388108., 0.25},
                         {15267082809. / 155376265600., -71443401. / 120774400., 730878875. / 902184768.,
                          2285395. / 8070912., 0.25},
                         {82889. / 524892., 0, 15625. / 83664., 69875. / 102672., -2260. / 8211., 0.25}}},
                  .c = {0, 0.5, 83. / 250., 31. / 50., 17. / 20., 1},
                  .error = {},
                  .nodes = {0, 2, 3, 5},
                  .probe = 4},
                 {4586570599. / 29645900160., 0, 178811875. / 945068544., 814220225. / 1159782912.,
                  -3700637. / 11593932., 61727. / 225920.});
  return t;
}

}  // namespace ostium::network
