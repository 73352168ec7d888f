/// Blocks joined at nodes of equal names, and the checks a user's network must pass before it is solved.
///
///   node      a name that terminals of blocks share; one pressure, flows sum to zero
///   ground    a terminal without a node: fixed pressure
///   opening   a node where the vessel adds its flow; where a single flow source stands, the vessel takes what
///             that sends and the node leaves the network
///
/// Refused, each with the remedy: opening without a block, node with a single block, velocity away from an
/// opening, several flow sources with nobody to take the difference, no pressure reference, pressure sources
/// against each other, and the two causes of index 2 (Ascher & Petzold 1998, ch. 9): nodes tied by inductors
/// and prescribed flows only, loops of capacitors and pressure sources.
/// Not checked: plausible values.
#pragma once
#include <string>
#include <vector>

#include "network/model.hpp"
#include "network/port.hpp"

namespace ostium::network {

/// `merged`: all openings are one node, an ideal junction in place of the vessel.
enum class Junction { separate, merged };

inline constexpr int outside = -1;  // instead of a node: a ground, or an opening whose flow is prescribed

struct Graph {
  std::vector<std::string> nodes;
  std::vector<std::vector<int>> node_of;  // [entry][terminal]: node or outside
  std::vector<std::vector<int>> port_of;  // [entry][terminal]: port or outside
  std::vector<int> port_node;             // node or outside (flow ports)
  std::vector<int> port_source;           // entry of the flow source of a flow port, else outside
  std::vector<PortKind> port_kind;
  std::vector<std::string> port_name;
  Junction junction = Junction::separate;
};

/// Joins and checks; throws UserError. Velocity sources of `model` are given the areas of their openings.
Graph make_graph(Model& model, const std::vector<Port>& ports, Junction junction = Junction::separate);

/// The checks of what is joined (network/graph_checks.cpp).
void check_graph(const Model& model, const Graph& graph);

}  // namespace ostium::network
