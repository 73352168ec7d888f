// Who is there and who is joined to whom: in the order in which svZeroDSolver makes its nodes.
#include <algorithm>
#include <set>

#include "app/import/svzerod_source.hpp"
#include "core/did_you_mean.hpp"

namespace ostium::app::svzerod {
namespace {

/// Types by kind; the name of the type stands under `type_key`.
const std::map<Kind, std::vector<std::string>>& types() {
  static const std::map<Kind, std::vector<std::string>> all{
      {Kind::vessel, {"BloodVessel", "BloodVesselCRL", "BloodVesselRC", "ChamberSphere"}},
      {Kind::coupling, {"FLOW", "PRESSURE"}},
      {Kind::boundary,
       {"FLOW", "PRESSURE", "RESISTANCE", "RCR", "CORONARY", "CORONARY_VAR_RES", "ClosedLoopRCR",
        "ClosedLoopCoronaryLeft", "ClosedLoopCoronaryRight"}},
      {Kind::junction, {"NORMAL_JUNCTION", "BloodVesselJunction", "resistive_junction"}},
      {Kind::heart, {"ClosedLoopHeartAndPulmonary"}},
      {Kind::valve, {"ValveTanh", "PiecewiseValve"}},
      {Kind::chamber,
       {"LinearElastanceChamber", "ChamberElastanceInductor", "ChamberElastanceInductorExponential"}}};
  return all;
}

class Reader {
 public:
  explicit Reader(Source& source) : source_(source), empty_(JsonNode::parse("{}")) {}

  void read() {
    list("vessels", Kind::vessel, "vessel_name", "zero_d_element_type", "zero_d_element_values");
    list("external_solver_coupling_blocks", Kind::coupling, "name", "type", "values");
    list("boundary_conditions", Kind::boundary, "bc_name", "bc_type", "bc_values");
    source_.root.at("boundary_conditions").items();
    list("junctions", Kind::junction, "junction_name", "junction_type", "junction_values");
    list("closed_loop_blocks", Kind::heart, nullptr, "closed_loop_type", "parameters");
    list("valves", Kind::valve, "name", "type", "params");
    list("chambers", Kind::chamber, "name", "type", "values");
    if (source_.parts.empty()) source_.root.error("the model has no blocks");
    connect();
    for (auto& part : source_.parts) check_ends(part);
  }

 private:
  void list(const char* key, Kind kind, const char* name_key, const char* type_key, const char* values_key) {
    for (const auto& item : source_.root.items_at(key)) {
      const std::string name = name_key ? item.at(name_key).text() : "CLH";
      const auto entry = item.labelled(name);
      const auto type = entry.at(type_key);
      const auto& known = types().at(kind);
      if (std::find(known.begin(), known.end(), type.text()) == known.end())
        type.error("there is no type \"{}\" here{}", type.text(), did_you_mean(type.text(), known));
      const bool needs_values = kind != Kind::junction || entry.find(values_key);
      add({kind, name, type.text(), entry, needs_values ? entry.at(values_key) : empty_, {}, {}});
      if (kind == Kind::heart) {
        add({Kind::junction, "J_heart_inlet", "NORMAL_JUNCTION", entry, empty_, {}, {}});
        add({Kind::junction, "J_heart_outlet", "NORMAL_JUNCTION", entry, empty_, {}, {}});
      }
    }
  }

  void add(Part part) {
    if (index_.contains(part.name))
      part.node.error("the name \"{}\" is taken by {}; names of blocks must differ{}", part.name,
                      source_.parts[index_[part.name]].node.path(),
                      part.kind == Kind::heart ? " (and there is one heart at most)" : "");
    index_[part.name] = static_cast<int>(source_.parts.size());
    source_.parts.push_back(std::move(part));
  }

  int find(const std::string& name, const JsonNode& where) const {
    const auto at = index_.find(name);
    if (at != index_.end()) return at->second;
    std::vector<std::string> names;
    for (const auto& [known, i] : index_) names.push_back(known);
    const auto near = nearest_name(name, names);
    where.error("there is no block \"{}\"{}", name, near ? "; did you mean \"" + *near + "\"?" : "");
  }

  void join(int up, int down, const JsonNode& where) {
    const std::string name = source_.parts[up].name + ":" + source_.parts[down].name;
    if (up == down) where.error("\"{}\" is joined to itself", source_.parts[up].name);
    if (!pairs_.insert({up, down}).second) where.error("the connection {} is made twice", name);
    const int id = static_cast<int>(source_.connections.size());
    source_.connections.push_back({up, down, name});
    source_.parts[up].out.push_back(id);
    source_.parts[down].in.push_back(id);
  }

  void connect() {
    for (std::size_t i = 0; i < source_.parts.size(); ++i) connect_vessel(static_cast<int>(i));
    for (std::size_t i = 0; i < source_.parts.size(); ++i) connect_coupling(static_cast<int>(i));
    for (std::size_t i = 0; i < source_.parts.size(); ++i) connect_junction(static_cast<int>(i));
    for (std::size_t i = 0; i < source_.parts.size(); ++i) connect_heart(static_cast<int>(i));
    for (std::size_t i = 0; i < source_.parts.size(); ++i) connect_valve(static_cast<int>(i));
  }

  void connect_vessel(int i) {
    const Part part = source_.parts[i];
    if (part.kind != Kind::vessel) return;
    const auto id = part.node.at("vessel_id");
    if (!ids_.emplace(id.integer_at_least(0), i).second)
      id.error("the vessel_id {} is given twice", id.integer_at_least(0));
    const auto ends = part.node.find("boundary_conditions");
    if (!ends) return;
    ends->check_keys({"inlet", "outlet"});
    if (const auto end = ends->find("inlet")) join(boundary(*end), i, *end);
    if (const auto end = ends->find("outlet")) join(i, boundary(*end), *end);
  }

  int boundary(const JsonNode& end) const {
    const int i = find(end.text(), end);
    if (source_.parts[i].kind != Kind::boundary)
      end.error("\"{}\" is no boundary condition but {}", end.text(), source_.parts[i].node.path());
    return i;
  }

  void connect_coupling(int i) {
    const Part part = source_.parts[i];
    if (part.kind != Kind::coupling) return;
    const auto location = part.node.at("location"), other = part.node.at("connected_block");
    if (location.text() != "inlet" && location.text() != "outlet")
      location.error("there is no location \"{}\"; allowed: inlet, outlet", location.text());
    if (other.text() == "ClosedLoopHeartAndPulmonary") {
      if (location.text() == "inlet") location.error("a heart is joined at its \"outlet\" only");
      find("CLH", other);  // joined through its list outlet_blocks
      return;
    }
    const int at = find(other.text(), other);
    location.text() == "inlet" ? join(i, at, other) : join(at, i, other);
  }

  void connect_junction(int i) {
    const Part part = source_.parts[i];
    if (part.kind != Kind::junction || part.node.find("closed_loop_type")) return;
    const bool by_id = part.node.find("inlet_vessels") && part.node.find("outlet_vessels");
    if (!by_id && !(part.node.find("inlet_blocks") && part.node.find("outlet_blocks")))
      part.node.error(
          "a junction needs \"inlet_vessels\" and \"outlet_vessels\" (ids), or \"inlet_blocks\" and "
          "\"outlet_blocks\" (names)");
    for (const auto& end : part.node.at(by_id ? "inlet_vessels" : "inlet_blocks").items())
      join(by_id ? vessel(end) : find(end.text(), end), i, end);
    for (const auto& end : part.node.at(by_id ? "outlet_vessels" : "outlet_blocks").items())
      join(i, by_id ? vessel(end) : find(end.text(), end), end);
  }

  int vessel(const JsonNode& id) const {
    const auto at = ids_.find(id.integer_at_least(0));
    if (at == ids_.end()) id.error("there is no vessel with the vessel_id {}", id.integer_at_least(0));
    return at->second;
  }

  /// Closed-loop blocks return to the heart by themselves.
  bool returns(const Part& part) const {
    if (part.kind != Kind::boundary) return false;
    if (part.type.starts_with("ClosedLoopCoronary")) return true;
    return part.type == "ClosedLoopRCR" && part.values.flag("closed_loop_outlet", false);
  }

  void connect_heart(int i) {
    const Part part = source_.parts[i];
    if (part.kind != Kind::heart) return;
    const int inlet = index_["J_heart_inlet"], outlet = index_["J_heart_outlet"];
    join(inlet, i, part.node);
    for (std::size_t k = 0; k < source_.parts.size(); ++k)
      if (returns(source_.parts[k])) join(static_cast<int>(k), inlet, source_.parts[k].node);
    join(i, outlet, part.node);
    for (const auto& end : part.node.at("outlet_blocks").items()) join(outlet, find(end.text(), end), end);
  }

  void connect_valve(int i) {
    const Part part = source_.parts[i];
    if (part.kind != Kind::valve) return;
    const auto up = part.values.at("upstream_block"), down = part.values.at("downstream_block");
    join(find(up.text(), up), i, up);
    join(i, find(down.text(), down), down);
  }

  void check_ends(const Part& part) const {
    const auto in = part.in.size(), out = part.out.size();
    if (part.kind == Kind::junction) {
      if (in == 0 || out == 0)
        part.node.error("nothing is joined to the {} of \"{}\"", in ? "outlet" : "inlet", part.name);
      return;
    }
    const bool two_ended =
        !(part.kind == Kind::coupling || part.kind == Kind::boundary) || part.type.starts_with("ClosedLoop");
    if (!two_ended && in + out != 1)
      part.node.error("\"{}\" is joined to {} blocks; it has one end, so name it at exactly one", part.name,
                      in + out);
    if (two_ended && in != 1)
      part.node.error("{} joined to the inlet of \"{}\"; it needs exactly one block there", counted(in),
                      part.name);
    if (two_ended && out != 1)
      part.node.error(
          "{} joined to the outlet of \"{}\"; it needs exactly one block there{}", counted(out), part.name,
          part.type == "ClosedLoopRCR" ? ", for example the heart with \"closed_loop_outlet\": true" : "");
  }

  static std::string counted(std::size_t n) {
    return n == 0 ? "nothing is" : std::to_string(n) + " blocks are";
  }

  Source& source_;
  JsonNode empty_;
  std::map<std::string, int> index_;
  std::map<int, int> ids_;
  std::set<std::pair<int, int>> pairs_;
};

}  // namespace

void read_parts(Source& source) { Reader(source).read(); }

}  // namespace ostium::app::svzerod
