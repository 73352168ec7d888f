/// The keys by which a case gives a waveform that is not constant: a file, an inline table or a Fourier
/// series.
#pragma once
#include "core/config.hpp"

namespace ostium::config {

struct WaveformForm {
  std::optional<std::filesystem::path> file;
  std::optional<Node> times, values, fourier;
  std::optional<std::string> unit, time_unit;
  std::optional<double> period;
  std::optional<int> modes;
  std::vector<std::string> columns;
  int skip = 0;
  double sign = 1, delay = 0;
  Interpolation interpolation = Interpolation::linear;
  Node origin;
};

inline std::string contradiction(const WaveformForm& f) {
  if (f.file.has_value() + f.times.has_value() + f.fourier.has_value() != 1)
    return "a waveform is given by exactly one of \"file\", \"times\" with \"values\", and \"fourier\"";
  if (f.times.has_value() != f.values.has_value()) return "\"times\" and \"values\" belong together";
  if (f.modes && !f.period) return "\"modes\" needs a period; add for example \"period: 0.8 s\"";
  return {};
}

inline void declare(Fields<WaveformForm>& f) {
  f.path("file", &WaveformForm::file,
         "table of times and values, separated by commas, semicolons, tabulators or blanks; units may stand "
         "in the "
         "header as in `flow [mL/s]`");
  f.raw("times", &WaveformForm::times, "list of times");
  f.raw("values", &WaveformForm::values, "list of values, as many as times");
  f.raw("fourier", &WaveformForm::fourier,
        "`{mean, cos: [..], sin: [..]}`: mean + sum of cos_n cos(2 pi n t/period) + sin_n sin(2 pi n "
        "t/period)");
  f.text("unit", &WaveformForm::unit, "unit of the values; goes before the one in the header");
  f.text("time_unit", &WaveformForm::time_unit, "unit of the times; a file without one is in s");
  f.quantity("period", &WaveformForm::period, "s", "the waveform repeats; without it the end values are held")
      .positive();
  f.choice("interpolation", &WaveformForm::interpolation,
           {{"linear", Interpolation::linear}, {"monotone_cubic", Interpolation::monotone_cubic}},
           "between the samples")
      .or_else(Interpolation::linear);
  f.integer("modes", &WaveformForm::modes, "replace the table by its first harmonics")
      .at_least(1)
      .at_most(500);
  f.choice("sign", &WaveformForm::sign, {{"1", 1.0}, {"+1", 1.0}, {"-1", -1.0}},
           "-1 where the source counts the other direction as positive")
      .or_else(1.0);
  f.quantity("delay", &WaveformForm::delay, "s", "the waveform comes this much later").or_else(0.0);
  f.texts("columns", &WaveformForm::columns, "names or numbers (from 1) of the columns of time and value")
      .or_else({});
  f.integer("skip", &WaveformForm::skip, "lines to leave out at the beginning of the file")
      .at_least(0)
      .or_else(0);
  f.origin(&WaveformForm::origin);
  f.check(contradiction);
}

}  // namespace ostium::config
