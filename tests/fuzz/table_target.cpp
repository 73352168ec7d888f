#include "core/config.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace ostium::fuzz {

void read_table_text(std::string_view content) {
  const std::string file = "inflow.csv";
  for (const char* form : {"{file: inflow.csv}", "{file: inflow.csv, unit: mL/s, period: 1 s, modes: 3}",
                           "{file: inflow.csv, unit: L/min, columns: [t, q], interpolation: monotone_cubic}"})
    accepted_or_refused("case.yaml", [&] {
      const Waveform w = config::read_waveform(
          config::Node::parse(form, "case.yaml"), "m3/s",
          [&](const auto&, int skip) { return parse_table(std::string(content), file, skip); });
      if (!(w.min() <= w.max()) || !(w.mean() == w.mean()))
        throw std::logic_error("a waveform of no numbers");
      w.kinks(0, 2);
    });
}

}  // namespace ostium::fuzz
