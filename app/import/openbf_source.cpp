#include "app/import/openbf_source.hpp"

#include <map>
#include <set>

#include "core/csv.hpp"
#include "core/waveform.hpp"

namespace ostium::app::openbf {
namespace {

std::string check_vessel(const VesselData& v) {
  if (!v.R0 && !v.Rp) return "the radius is missing; give R0, or Rp and Rd";
  if (v.sn == v.tn) return fmt::format("the vessel begins and ends at the node {}", v.sn);
  if (v.R2 && !v.R1) return "R2 needs R1 in front of it";
  if (v.R1 && !v.Cc) return "R1 needs the compliance Cc of its Windkessel";
  return {};
}

struct Document {
  std::string project_name;
  std::optional<std::filesystem::path> inlet_file;
  BloodData blood;
  std::vector<VesselData> network;
  std::optional<config::Node> ignored;  // what steers its numerics and output
};

void declare(config::Fields<Document>& f) {
  f.text("project_name", &Document::project_name, "name of the model").or_else("openbf");
  f.path("inlet_file", &Document::inlet_file, "times and flows at the inlet; NAME_inlet.dat if not given");
  f.section("blood", &Document::blood, "density and viscosity");
  f.sections("network", &Document::network, "the vessels");
  f.raw("solver", &Document::ignored, "numbers of its method");
  f.raw("write_results", &Document::ignored, "what it writes");
  f.raw("output_directory", &Document::ignored, "where it writes");
}

void read_inlet(Source& s, const std::filesystem::path& file) {
  const Table table = read_table(file);
  if (table.columns.size() < 2 || table.lines.size() < 2)
    user_error(
        "{}: the inflow needs two columns, times in s and flows in m3/s, and two rows at least; found {} "
        "columns",
        file.string(), table.columns.size());
  s.times = table.columns[0], s.flow = table.columns[1];
  Waveform::check({.times = s.times, .values = s.flow, .period = s.times.back()},
                  [&](std::size_t i) { return fmt::format("{}:{}", file.string(), table.lines[i]); });
  if (s.times.front() != 0)
    user_error(
        "{}:{}: the inflow begins at {:g} s; openBF repeats it from 0 to its last time, let it begin at 0",
        file.string(), table.lines.front(), s.times.front());
}

/// The node that vessels leave and none reaches.
int inlet_of(const Source& s, const std::string& file) {
  std::set<int> begins, ends;
  for (const auto& v : s.vessels) begins.insert(v.sn), ends.insert(v.tn);
  std::vector<int> inlets;
  for (const int n : begins)
    if (!ends.count(n)) inlets.push_back(n);
  if (inlets.size() != 1)
    user_error(
        "{}: {} nodes begin vessels and end none, {} is allowed: the inlet; check sn and tn of the vessels",
        file, inlets.size(), "one");
  return inlets.front();
}

void check_labels(const Source& s) {
  std::map<std::string, const VesselData*> seen;
  for (const auto& v : s.vessels)
    if (const auto [first, fresh] = seen.emplace(v.label, &v); !fresh)
      v.origin.error("there are two vessels labelled \"{}\" (the other one: {}); rename one of them", v.label,
                     first->second->origin.where());
}

/// A vessel behind which nothing follows and nothing ends it.
void check_ends(const Source& s) {
  std::set<int> begins;
  for (const auto& v : s.vessels) begins.insert(v.sn);
  for (const auto& v : s.vessels) {
    const bool last = !begins.count(v.tn), ended = v.R1 || v.Rt;
    if (last && !ended)
      v.origin.error(
          "the vessel \"{}\" is a last one and has no outlet; give R1, R2 and Cc of a Windkessel, or Rt",
          v.label);
    if (!last && ended)
      v.origin.error(
          "the vessel \"{}\" has an outlet, but vessels begin at its end, node {}; drop the one or the other",
          v.label, v.tn);
  }
}

}  // namespace

void declare(config::Fields<BloodData>& f) {
  f.number("rho", &BloodData::rho, "density, kg/m3").positive();
  f.number("mu", &BloodData::mu, "dynamic viscosity, Pa.s").positive();
}

void declare(config::Fields<VesselData>& f) {
  using V = VesselData;
  f.text("label", &V::label, "name");
  f.integer("sn", &V::sn, "node it begins at");
  f.integer("tn", &V::tn, "node it ends at");
  f.number("L", &V::L, "length, m").positive();
  f.number("E", &V::E, "stiffness of the wall, Pa").positive();
  f.number("R0", &V::R0, "radius, m").positive();
  f.number("Rp", &V::Rp, "radius at the begin, m").positive();
  f.number("Rd", &V::Rd, "radius at the end, m").positive();
  f.number("h0", &V::h0, "thickness of the wall, m").positive();
  f.number("Pext", &V::Pext, "pressure at these radii, Pa").or_else(0.0);
  f.number("gamma_profile", &V::gamma_profile, "power of the velocity profile").positive().or_else(2.0);
  f.number("R1", &V::R1, "proximal resistance, Pa.s/m3").non_negative();
  f.number("R2", &V::R2, "distal resistance, Pa.s/m3").non_negative();
  f.number("Cc", &V::Cc, "compliance of the bed, m3/Pa").positive();
  f.number("Rt", &V::Rt, "reflection coefficient").at_least(-1).at_most(1);
  f.flag("inlet_impedance_matching", &V::impedance_matching, "R1 follows the vessel's wave impedance")
      .or_else(false);
  f.flag("visco-elastic", &V::visco_elastic, "the wall has viscosity").or_else(false);
  f.raw("M", &V::ignored, "number of its cells");
  f.raw("to_save", &V::ignored, "whether it writes the vessel");
  f.raw("outlet", &V::ignored, "kind of its outlet; the keys say it");
  f.raw("initial_pressure", &V::ignored, "where it starts");
  f.raw("initial_flow", &V::ignored, "where it starts");
  f.origin(&V::origin);
  f.check(check_vessel);
}

Source read_source(const config::Node& root, std::vector<std::string>& notes) {
  const std::filesystem::path file = root.file();
  Document d = config::read<Document>(root);
  Source s{
      .name = d.project_name, .blood = d.blood, .vessels = std::move(d.network), .times = {}, .flow = {}};
  if (s.vessels.empty()) root.at("network").error("there are no vessels");
  check_labels(s);
  check_ends(s);
  s.inlet = inlet_of(s, file.string());
  try {
    read_inlet(s, d.inlet_file.value_or(file.parent_path() / (s.name + "_inlet.dat")));
  } catch (const UserError& e) {
    root.find("inlet_file").value_or(root).error("{}", e.what());
  }
  for (const auto& v : s.vessels)
    if (v.visco_elastic) notes.push_back("viscosity of the wall of \"" + v.label + "\"");
  return s;
}

}  // namespace ostium::app::openbf
