#include "core/config/numbers.hpp"

namespace ostium::config {

namespace {

using Series = Waveform::Fourier;

void visit_harmonics(Waveform& w, const FieldInfo& info, const std::string& key,
                     std::vector<double> Series::*part, const NumberVisitor& visit) {
  const auto now = w.series().*part;
  for (std::size_t n = 0; n < now.size(); ++n)
    visit({key + "." + std::to_string(n + 1), info.unit}, now[n], [&w, part, n](double value) {
      Series series = w.series();
      (series.*part)[n] = value;
      w = Waveform::fourier(std::move(series));
    });
}

}  // namespace

void visit_waveform(Waveform& w, const FieldInfo& info, const std::string& key, const NumberVisitor& visit) {
  if (w.is_constant()) {
    visit({key, info.unit, info.range}, w.mean(), [&w](double value) { w = Waveform::constant(value); });
    return;
  }
  visit({key + ".factor", "1"}, 1, [&w](double factor) { w = w.scaled(factor); });
  visit({key + ".shift", "s"}, 0, [&w](double shift) { w = w.delayed(shift); });
  if (w.form() != Waveform::Form::fourier) return;
  visit({key + ".fourier.mean", info.unit}, w.mean(), [&w](double mean) {
    Series series = w.series();
    series.mean = mean;
    w = Waveform::fourier(std::move(series));
  });
  visit_harmonics(w, info, key + ".fourier.cos", &Series::cos, visit);
  visit_harmonics(w, info, key + ".fourier.sin", &Series::sin, visit);
}

}  // namespace ostium::config
