#include "app/import/svzerod_calibration.hpp"

#include "app/import/svzerod_source.hpp"

namespace ostium::app {

namespace {

using Eigen::VectorXd;
using network::EndsOfVessel;
using network::VesselFit;
using network::VesselParameters;
using svzerod::Kind;
using svzerod::Part;
using svzerod::Source;

/// The values and rates of the unknowns at a connection, all of one length.
class Observations {
 public:
  explicit Observations(const JsonNode& root) : y_(root.at("y")), dy_(root.at("dy")) {
    const auto entries = y_.entries();
    if (entries.empty())
      y_.error("holds no observations; give flow:UP:DOWN and pressure:UP:DOWN of every connection");
    count_ = entries.front().second.numbers().size();
    if (count_ == 0) entries.front().second.error("has no values; give one per observation");
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(count_); }
  VectorXd value(const char* quantity, const std::string& connection) const {
    return series(y_, std::string(quantity) + ":" + connection);
  }
  VectorXd rate(const char* quantity, const std::string& connection) const {
    return series(dy_, std::string(quantity) + ":" + connection);
  }

 private:
  VectorXd series(const JsonNode& of, const std::string& name) const {
    const auto node = of.at(name);
    const auto v = node.numbers();
    if (v.size() != count_)
      node.error(
          "has {} values where the first series of \"y\" has {}; all series need one value per observation",
          v.size(), count_);
    return Eigen::Map<const VectorXd>(v.data(), count());
  }
  JsonNode y_, dy_;
  std::size_t count_ = 0;
};

class Calibration {
 public:
  explicit Calibration(const JsonNode& root) : source_(parts_of(root)), seen_(root) {
    options_.balanced = false;  // that program's least squares
    result_.model = root.json();
    for (const char* key : {"y", "dy", "calibration_parameters"}) result_.model.erase(key);
    result_.observations = static_cast<std::size_t>(seen_.count());
    if (const auto given = root.find("calibration_parameters")) {
      options_.stenosis = given->flag("calibrate_stenosis_coefficient", true);
      options_.compliance = !given->flag("set_capacitance_to_zero", false);
    }
  }

  SvzerodCalibration run() {
    std::size_t vessel = 0, junction = 0;
    for (const auto& part : source_.parts) {
      if (part.kind == Kind::vessel) fit_vessel(part, result_.model["vessels"][vessel++]);
      if (part.kind == Kind::junction && !part.node.find("closed_loop_type"))
        fit_junction(part, result_.model["junctions"][junction++]);
    }
    if (result_.fitted.empty())
      source_.root.error(
          "holds observations but nothing to fit; vessels (BloodVessel, BloodVesselCRL) and junctions with "
          "one inlet and several outlets are fitted");
    return std::move(result_);
  }

 private:
  static Source parts_of(const JsonNode& root) {
    Source source(root);
    svzerod::read_parts(source);
    return source;
  }
  const std::string& name(int connection) const { return source_.connections[connection].name; }

  VesselFit keep(const std::string& name, const EndsOfVessel& ends, const VesselParameters& start,
                 const network::VesselFitOptions& options) {
    result_.fitted.push_back({name, network::fit_vessel(ends, start, options)});
    return result_.fitted.back().fit;
  }

  void fit_vessel(const Part& part, JsonNode::Json& entry) {
    if (part.type != "BloodVessel" && part.type != "BloodVesselCRL") {
      result_.notes.push_back(part.name + ": a " + part.type + " is not fitted, it stays as it is");
      return;
    }
    part.values.check_keys({"R_poiseuille", "C", "L", "stenosis_coefficient"});
    const auto &in = name(part.in[0]), &out = name(part.out[0]);
    const EndsOfVessel ends{.p_in = seen_.value("pressure", in),
                            .p_out = seen_.value("pressure", out),
                            .q_in = seen_.value("flow", in),
                            .q_out = seen_.value("flow", out),
                            .dp_in = seen_.rate("pressure", in),
                            .dq_in = seen_.rate("flow", in),
                            .dq_out = seen_.rate("flow", out),
                            .compliance_first = part.type == "BloodVesselCRL"};
    const auto at = [&](const char* key) { return part.values.number(key, 0); };
    const VesselParameters p =
        keep(part.name, ends, {at("R_poiseuille"), at("C"), at("L"), at("stenosis_coefficient")}, options_)
            .parameters;
    auto& values = entry["zero_d_element_values"];
    values["R_poiseuille"] = p.R, values["C"] = p.C, values["L"] = p.L, values["stenosis_coefficient"] = p.S;
  }

  void fit_junction(const Part& part, JsonNode::Json& entry) {
    if (part.out.size() < 2) return;
    if (part.in.size() > 1 || part.type == "resistive_junction") {
      result_.notes.push_back(part.name + ": only junctions with one inlet are fitted, it stays as it is");
      return;
    }
    JsonNode::Json R = JsonNode::Json::array(), L = R, S = R;
    for (std::size_t i = 0; i < part.out.size(); ++i) {
      const VesselParameters p = fit_outlet(part, i).parameters;
      R.push_back(p.R), L.push_back(p.L), S.push_back(p.S);
    }
    entry["junction_type"] = "BloodVesselJunction";
    entry["junction_values"] = {{"R_poiseuille", R}, {"L", L}, {"stenosis_coefficient", S}};
  }

  /// Pin - Pout = (R + S|Qout|) Qout + L dQout/dt: a vessel without compliance that carries the outlet's flow.
  VesselFit fit_outlet(const Part& part, std::size_t i) {
    const auto &in = name(part.in[0]), &out = name(part.out[i]);
    const VectorXd q = seen_.value("flow", out), dq = seen_.rate("flow", out);
    const EndsOfVessel ends{.p_in = seen_.value("pressure", in),
                            .p_out = seen_.value("pressure", out),
                            .q_in = q,
                            .q_out = q,
                            .dp_in = seen_.rate("pressure", in),
                            .dq_in = dq,
                            .dq_out = dq};
    return keep(out, ends, start_of(part, i),
                {.stenosis = options_.stenosis, .compliance = false, .balanced = false});
  }

  static VesselParameters start_of(const Part& part, std::size_t i) {
    if (part.type != "BloodVesselJunction") return {};
    const auto at = [&](const char* key) {
      const auto list = part.values.at(key);
      const auto v = list.numbers();
      if (v.size() != part.out.size())
        list.error("has {} values for {} outlets; give one per outlet", v.size(), part.out.size());
      return v[i];
    };
    return {at("R_poiseuille"), 0, at("L"), at("stenosis_coefficient")};
  }

  Source source_;
  Observations seen_;
  network::VesselFitOptions options_;
  SvzerodCalibration result_;
};

}  // namespace

bool has_observations(const JsonNode& root) {
  return root.find("y").has_value() || root.find("dy").has_value();
}

SvzerodCalibration calibrate_svzerod(const JsonNode& root) { return Calibration(root).run(); }

}  // namespace ostium::app
