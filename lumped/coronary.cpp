#include "lumped/coronary.hpp"

namespace ostium::lumped {

std::vector<Terminal> Coronary::terminals() const {
  TwoTerminal ends;
  ends.from = from, ends.to = to;
  auto all = distal_end(ends, Pd);
  if (ventricle && ventricle->empty())
    user_error("has a ventricle without a name; write for example `ventricle: LV`");
  all.push_back({"ventricle", ventricle.value_or(""), 0});
  return all;
}

std::vector<double> Coronary::kinks(double t0, double t1) const {
  auto all = Pim.kinks(t0, t1);
  if (!Ram_max) return all;
  const auto more = activation->kinks(t0, t1);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

namespace {

std::string check_coronary(const Coronary& c) {
  if (c.Ram_max.has_value() == c.activation.has_value()) return {};
  return c.Ram_max ? "\"Ram_max\" needs an \"activation\" that says when the arterioles are throttled"
                   : "\"activation\" needs \"Ram_max\", the resistance to which the arterioles are throttled";
}

}  // namespace

void declare(config::Fields<Coronary>& f) {
  f.text("from", &Coronary::from, "node its flow comes from");
  f.text("to", &Coronary::to, "node its flow goes to");
  f.text("ventricle", &Coronary::ventricle, "node whose pressure squeezes the bed, besides Pim");
  f.quantity("Ra", &Coronary::Ra, "Pa.s/m3", "resistance of the large arteries").non_negative();
  f.quantity("Ram", &Coronary::Ram, "Pa.s/m3", "resistance of the arterioles in the muscle").positive();
  f.quantity("Rv", &Coronary::Rv, "Pa.s/m3", "resistance of the veins").positive();
  f.quantity("Ca", &Coronary::Ca, "m3/Pa", "compliance of the arteries").non_negative();
  f.quantity("Cim", &Coronary::Cim, "m3/Pa", "compliance of the bed in the muscle").positive();
  f.waveform("Pim", &Coronary::Pim, "Pa", "intramyocardial pressure against time").or_else(Waveform());
  f.number("share", &Coronary::share, "part of the pressure of `ventricle` that reaches the bed")
      .at_least(0)
      .at_most(10)
      .or_else(1);
  f.quantity("Pd", &Coronary::Pd, "Pa", "distal pressure where there is no node `to`; 0 if not given");
  f.quantity("Ram_max", &Coronary::Ram_max, "Pa.s/m3",
             "resistance of the arterioles at full activation; constant without")
      .positive();
  f.section("activation", &Coronary::activation, "course of the throttling, with Ram_max");
  f.quantity("initial_pressure", &Coronary::initial_pressure, "Pa",
             "pressure on Ca at the start; Pd if not given");
  f.quantity("initial_volume", &Coronary::initial_volume, "m3",
             "blood in Cim at the start; if not given what Pd holds against Pim");
  f.check(check_coronary);
}

}  // namespace ostium::lumped
