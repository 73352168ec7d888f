/// The places where a network meets a vessel.
#pragma once
#include <string>

namespace ostium::network {

/// An opening of the vessel; the network's node of the same name is coupled to it.
struct Port {
  std::string opening;
  double area = 0;  // m2
};

/// `flow`: a single flow source stands at the node, the network prescribes the flow. `pressure`: anything
/// else.
enum class PortKind { pressure, flow };

}  // namespace ostium::network
