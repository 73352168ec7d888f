// The keys of an activation: which curve needs which.
#include <algorithm>

#include "lumped/activation.hpp"

namespace ostium::lumped {

namespace {

using Form = Activation::Form;

struct Key {
  const char* name;
  bool given;
};

std::vector<Key> keys_given(const Activation& a) {
  return {{"start", a.start.has_value()},
          {"end", a.end.has_value()},
          {"duration", a.duration.has_value()},
          {"contract_start", a.contract_start.has_value()},
          {"contract_duration", a.contract_duration.has_value()},
          {"relax_start", a.relax_start.has_value()},
          {"relax_duration", a.relax_duration.has_value()},
          {"tau_1", a.tau_1.has_value()},
          {"tau_2", a.tau_2.has_value()},
          {"m1", a.m1.has_value()},
          {"m2", a.m2.has_value()},
          {"mean", a.mean.has_value()},
          {"cos", a.cos.has_value()},
          {"sin", a.sin.has_value()},
          {"table", a.table.has_value()},
          {"period", a.period.has_value()}};
}

struct Needs {
  std::string name;
  std::vector<std::string> needed, allowed;
};

Needs needs_of(Form form) {
  switch (form) {
    case Form::half_cosine:
      return {"half_cosine", {"period", "start", "duration"}, {}};
    case Form::wrapping_cosine:
      return {"wrapping_cosine", {"period", "end", "duration"}, {}};
    case Form::piecewise_cosine:
      return {"piecewise_cosine",
              {"period", "contract_start", "contract_duration", "relax_start", "relax_duration"},
              {}};
    case Form::double_hill:
      return {"double_hill", {"period", "start", "tau_1", "tau_2", "m1", "m2"}, {}};
    case Form::fourier:
      return {"fourier", {"period", "mean"}, {"cos", "sin"}};
    case Form::ventricle:
      return {"ventricle", {"period"}, {}};
    case Form::table:
      return {"table", {"table"}, {}};
  }
  return {};
}

bool among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& n : names) text += (text.empty() ? "\"" : ", \"") + n + "\"";
  return text;
}

std::string check_keys(const Activation& a) {
  const Needs needs = needs_of(a.form);
  for (const auto& key : keys_given(a)) {
    if (!key.given && among(key.name, needs.needed))
      return "the activation \"" + needs.name + "\" needs \"" + key.name + "\"; its keys are " +
             listed(needs.needed);
    if (key.given && !among(key.name, needs.needed) && !among(key.name, needs.allowed))
      return "the activation \"" + needs.name + "\" has no key \"" + key.name + "\"; its keys are " +
             listed(needs.needed) + (needs.allowed.empty() ? "" : ", " + listed(needs.allowed));
  }
  return {};
}

std::string too_long(const char* key, double duration, double period) {
  return fmt::format("\"{}\" is {:g} s, longer than the period of {:g} s; a beat must hold it", key, duration,
                     period);
}

std::string check_activation(const Activation& a) {
  if (auto sentence = check_keys(a); !sentence.empty()) return sentence;
  if (a.duration && *a.duration > *a.period) return too_long("duration", *a.duration, *a.period);
  if (a.contract_duration && *a.contract_duration + *a.relax_duration > *a.period * (1 + 1e-12))
    return too_long("contract_duration\" and \"relax_duration", *a.contract_duration + *a.relax_duration,
                    *a.period);
  return {};
}

}  // namespace

void declare(config::Fields<Activation>& f) {
  f.choice("type", &Activation::form,
           {{"half_cosine", Form::half_cosine},
            {"wrapping_cosine", Form::wrapping_cosine},
            {"piecewise_cosine", Form::piecewise_cosine},
            {"double_hill", Form::double_hill},
            {"fourier", Form::fourier},
            {"ventricle", Form::ventricle},
            {"table", Form::table}},
           "the curve of the activation");
  f.quantity("period", &Activation::period, "s", "period of the beat").positive();
  f.quantity("start", &Activation::start, "s", "begin of the contraction (half_cosine, double_hill)");
  f.quantity("end", &Activation::end, "s", "end of the activation (wrapping_cosine)");
  f.quantity("duration", &Activation::duration, "s", "length of rise and fall together").positive();
  f.quantity("contract_start", &Activation::contract_start, "s", "begin of the rise (piecewise_cosine)");
  f.quantity("contract_duration", &Activation::contract_duration, "s", "length of the rise").positive();
  f.quantity("relax_start", &Activation::relax_start, "s", "begin of the fall");
  f.quantity("relax_duration", &Activation::relax_duration, "s", "length of the fall").positive();
  f.quantity("tau_1", &Activation::tau_1, "s", "time of the rise (double_hill)").positive();
  f.quantity("tau_2", &Activation::tau_2, "s", "time of the fall").positive();
  f.number("m1", &Activation::m1, "steepness of the rise").positive();
  f.number("m2", &Activation::m2, "steepness of the fall").positive();
  f.number("mean", &Activation::mean, "mean value (fourier)");
  f.list("cos", &Activation::cos, "1", "cosine coefficients of the harmonics 1, 2, ...");
  f.list("sin", &Activation::sin, "1", "sine coefficients of the harmonics 1, 2, ...");
  f.waveform("table", &Activation::table, "1", "activation against time (table)");
  f.check(check_activation);
}

}  // namespace ostium::lumped
