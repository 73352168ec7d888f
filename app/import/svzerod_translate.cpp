// From parts to blocks: first which nodes are one, then each part by its kind.
#include "app/import/svzerod_circuit.hpp"

namespace ostium::app::svzerod {
namespace {

void join_all(Circuit& circuit, const Part& part) {
  for (const auto* ends : {&part.in, &part.out})
    for (int c : *ends) circuit.join(c, part.in.front());
}

/// Losses of a junction's branch that are all zero: its nodes are one.
bool lossless(const Part& junction, std::size_t branch) {
  for (const char* key : {"R_poiseuille", "L", "stenosis_coefficient"}) {
    const auto list = junction.values.at(key).numbers();
    if (list.size() != junction.out.size())
      junction.values.at(key).error("has {} values for the {} outlets of the junction; give one per outlet",
                                    list.size(), junction.out.size());
    if (list[branch] != 0) return false;
  }
  return true;
}

void join_nodes(Circuit& circuit, const Part& part) {
  if (part.type == "NORMAL_JUNCTION" || part.type == "LinearElastanceChamber" || part.type == "ChamberSphere")
    join_all(circuit, part);
  if (part.type != "BloodVesselJunction") return;
  part.values.check_keys({"R_poiseuille", "L", "stenosis_coefficient"});
  if (part.in.size() != 1)
    part.node.error(
        "a BloodVesselJunction has one inlet, found {}; take a NORMAL_JUNCTION and vessels for the losses",
        part.in.size());
  for (std::size_t i = 0; i < part.out.size(); ++i)
    if (lossless(part, i)) circuit.join(part.in[0], part.out[i]);
}

}  // namespace

void translate(Circuit& circuit) {
  for (const auto& part : circuit.source.parts) join_nodes(circuit, part);
  for (const auto& part : circuit.source.parts)
    if (part.kind == Kind::junction) circuit.name_node(part.in.front(), part.name);
  for (const auto& part : circuit.source.parts) switch (part.kind) {
      case Kind::vessel:
        translate_vessel(circuit, part);
        break;
      case Kind::coupling:
      case Kind::boundary:
        translate_boundary(circuit, part);
        break;
      case Kind::junction:
        translate_junction(circuit, part);
        break;
      case Kind::heart:
        translate_heart(circuit, part);
        break;
      case Kind::valve:
        translate_valve(circuit, part);
        break;
      case Kind::chamber:
        translate_chamber(circuit, part);
        break;
    }
}

}  // namespace ostium::app::svzerod
