/// A struct with every kind of field, for the tests of the configuration.
#pragma once
#include "core/config.hpp"

namespace ostium::test {

enum class Scheme { linearised, held };

struct Windkessel {
  double Rp = 0, C = 0, Pd = 0;
  bool operator==(const Windkessel&) const = default;
};

inline void declare(config::Fields<Windkessel>& f) {
  f.quantity("Rp", &Windkessel::Rp, "Pa.s/m3", "proximal resistance").positive();
  f.quantity("C", &Windkessel::C, "m3/Pa", "compliance").positive();
  f.quantity("Pd", &Windkessel::Pd, "Pa", "distal pressure").or_else(0.0);
}

struct Output {
  double every = 0;
  std::optional<double> fields_every;
  bool operator==(const Output&) const = default;
};

inline void declare(config::Fields<Output>& f) {
  f.quantity("every", &Output::every, "s", "interval of the series").positive().or_else(0.01);
  f.quantity("fields_every", &Output::fields_every, "s", "interval of the fields").positive();
}

struct Study {
  std::string title;
  double porosity = 0, length_unit = 0;
  int cycles = 0;
  bool force = false;
  Scheme scheme = Scheme::linearised;
  std::optional<Scheme> fallback_scheme;
  std::filesystem::path file;
  std::vector<double> stations;
  std::optional<std::array<double, 3>> point;
  std::vector<std::string> tags;
  Output output;
  std::vector<Output> outputs;
  std::vector<std::pair<std::string, Windkessel>> blocks;
  Waveform flow;
  config::Node extra;
};

inline void declare(config::Fields<Study>& f) {
  f.text("title", &Study::title, "what this is").or_else("");
  f.number("porosity", &Study::porosity, "void fraction").at_least(0).below(1).or_else(0.5);
  f.unit("length_unit", &Study::length_unit, "m", "unit of the file").or_else(1.0);
  f.integer("cycles", &Study::cycles, "number of cycles").at_least(1).at_most(100).or_else(2);
  f.flag("force", &Study::force, "go on despite warnings").or_else(false);
  f.choice("scheme", &Study::scheme, {{"linearised", Scheme::linearised}, {"held", Scheme::held}},
           "coupling scheme")
      .or_else(Scheme::linearised);
  f.choice("fallback_scheme", &Study::fallback_scheme,
           {{"linearised", Scheme::linearised}, {"held", Scheme::held}}, "");
  f.path("file", &Study::file, "a file").or_else("data.csv");
  f.list("stations", &Study::stations, "m", "places along the axis").or_else({});
  f.list("point", &Study::point, "m", "a point");
  f.texts("tags", &Study::tags, "words").or_else({});
  f.section("output", &Study::output, "what is written");
  f.sections("outputs", &Study::outputs, "more of it").or_else({});
  f.map("blocks", &Study::blocks, "the elements").or_else({});
  f.waveform("flow", &Study::flow, "m3/s", "inflow").or_else(Waveform());
  f.raw("extra", &Study::extra, "for somebody else").or_else({});
}

inline Study read_study(const std::string& yaml) {
  return config::read<Study>(config::Node::parse(yaml, "case.yaml"));
}

}  // namespace ostium::test
