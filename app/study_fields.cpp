// The keys of the sections for studies of a network alone: sensitivities, calibration, sweep.
#include "app/case.hpp"

namespace ostium::app {

void declare(config::Fields<SensitivityCase>& f) {
  f.texts("of", &SensitivityCase::of,
          "results: `mean S`, `max S`, `min S`, `pulse S`, `ejection_fraction V`, `stroke_volume V` (or of a "
          "flow Q), "
          "`flow_split Q / Q0`, where S is a series of network.csv such as p:Ao, V a volume, Q a flow");
  f.texts(
      "to", &SensitivityCase::to,
      "parameters: `BLOCK.KEY` with a key the case gives, `body.Rd`, `lv.activation.duration`; of a waveform "
      "`heart.flow.factor`, `heart.flow.shift`, `heart.flow.fourier.mean`, `.cos.1`, `.sin.1`");
  f.origin(&SensitivityCase::origin);
  f.check([](const SensitivityCase& s) -> std::string {
    if (!s.of.empty() && !s.to.empty()) return {};
    return "\"of\" and \"to\" name at least one result and one parameter each; write for example {of: [mean "
           "p:Ao], to: [body.Rd]}";
  });
}

void declare(config::Fields<TargetCase>& f) {
  f.text("of", &TargetCase::of, "the result, as in `sensitivities.of`: `mean p:Ao`").required();
  f.text("value", &TargetCase::value, "what it should be, with its unit: `93 mmHg`").required();
  f.text("tolerance", &TargetCase::tolerance, "how near is near, with its unit: `1 mmHg`").required();
  f.number("weight", &TargetCase::weight, "more for what counts more").positive().or_else(1);
  f.origin(&TargetCase::origin);
}

void declare(config::Fields<FreeParameterCase>& f) {
  f.text("name", &FreeParameterCase::name, "the parameter, as in `sensitivities.to`: `body.Rd`").required();
  f.text("low", &FreeParameterCase::low, "least value, with its unit").required();
  f.text("high", &FreeParameterCase::high, "largest value, with its unit").required();
  f.choice("scale", &FreeParameterCase::logarithmic, {{"log", true}, {"linear", false}},
           "log for what may change by factors, linear for what may change its sign")
      .or_else(true);
  f.origin(&FreeParameterCase::origin);
}

void declare(config::Fields<CalibrationCase>& f) {
  f.sections("targets", &CalibrationCase::targets, "results over the last period and what they should be")
      .required();
  f.sections("parameters", &CalibrationCase::parameters, "what may be changed, and how far").required();
  f.integer("most_runs", &CalibrationCase::most_runs, "runs after which the search ends")
      .at_least(1)
      .or_else(60);
  f.origin(&CalibrationCase::origin);
  f.check([](const CalibrationCase& c) -> std::string {
    if (!c.targets.empty() && !c.parameters.empty()) return {};
    return "a calibration needs at least one of \"targets\" and one of \"parameters\"";
  });
}

namespace {

std::string check_swept_parameter(const SweptParameterCase& p) {
  const bool range =
      p.low || p.high || p.mean || p.standard_deviation || p.normal || p.logarithmic || p.count;
  if (p.values && range) return "give either \"values\" or a distribution, not both";
  if (p.normal && p.logarithmic)
    return "a normal distribution has no logarithmic scale; choose `distribution: uniform` or `scale: "
           "linear`";
  if (p.normal != p.mean.has_value() || p.normal != p.standard_deviation.has_value())
    return "`distribution: normal`, \"mean\" and \"standard_deviation\" belong together; give all three, or "
           "\"low\" and \"high\" alone";
  return {};
}

std::string check_sweep(const SweepCase& s) {
  if (s.sample.has_value() == s.file.has_value())
    return "give either \"sample\" (grid, random, latin_hypercube, saltelli) or the \"file\" of the samples";
  const bool grid = s.sample == network::Sampling::grid;
  if (s.count && (grid || s.file))
    return grid ? "a grid has a \"count\" for each parameter, none of its own; move it there"
                : "the file says how many samples there are; leave \"count\" out";
  if (s.sample && !grid && !s.count)
    return "the number of samples is missing; add for example \"count: 1000\"";
  if (s.sample && s.parameters.empty())
    return "no parameter varies; add for example \"parameters: [{name: body.Rd, low: 1e8 Pa.s/m3, high: 2e8 "
           "Pa.s/m3}]\"";
  if (s.results.empty()) return "no result is asked for; add for example \"results: [mean p:Ao]\"";
  return {};
}

}  // namespace

void declare(config::Fields<SweptParameterCase>& f) {
  f.text("name", &SweptParameterCase::name, "the parameter, as in `sensitivities.to`: `body.Rd`").required();
  f.text("low", &SweptParameterCase::low, "least value, with its unit");
  f.text("high", &SweptParameterCase::high, "largest value, with its unit");
  f.choice("scale", &SweptParameterCase::logarithmic, {{"linear", false}, {"log", true}},
           "log: uniform in the logarithm, in a grid by equal factors")
      .or_else(false);
  f.choice("distribution", &SweptParameterCase::normal, {{"uniform", false}, {"normal", true}},
           "between low and high, or normal, cut off at low and high where they are given")
      .or_else(false);
  f.text("mean", &SweptParameterCase::mean, "of a normal distribution, with its unit");
  f.text("standard_deviation", &SweptParameterCase::standard_deviation,
         "of a normal distribution, with its unit");
  f.integer("count", &SweptParameterCase::count, "in a grid: values from low to high").at_least(2);
  f.texts("values", &SweptParameterCase::values,
          "instead: these values, each with its unit; outside a grid each is as likely as the others");
  f.origin(&SweptParameterCase::origin);
  f.check(check_swept_parameter);
}

void declare(config::Fields<SweepCase>& f) {
  f.choice("sample", &SweepCase::sample,
           {{"grid", network::Sampling::grid},
            {"random", network::Sampling::random},
            {"latin_hypercube", network::Sampling::latin_hypercube},
            {"saltelli", network::Sampling::saltelli}},
           "grid: all combinations; random: independent draws; latin_hypercube: evenly spread over each "
           "parameter; saltelli: what Sobol indices need, count (parameters + 2) runs");
  f.path("file", &SweepCase::file,
         "instead: a CSV file with a row per sample and a column per parameter, `body.Rd [Pa.s/m3]`; "
         "`parameters` then names the columns to use, without it all");
  f.integer("count", &SweepCase::count, "samples; of `saltelli` base samples").at_least(1);
  f.integer("seed", &SweepCase::seed, "another one gives other samples").at_least(0).or_else(1);
  f.sections("parameters", &SweepCase::parameters, "what varies, independently of each other").or_else({});
  f.texts("results", &SweepCase::results,
          "columns of the table, as in `sensitivities.of`: `mean p:Ao`, `pulse p:Ao`, `ejection_fraction "
          "v:lv.V`")
      .required();
  f.origin(&SweepCase::origin);
  f.check(check_sweep);
}

}  // namespace ostium::app
