/// The blocks of a case as read, before they are joined to a network.
///
///   blocks:
///     heart: {type: flow_source, flow: {file: inflow.csv, period: 0.66 s}, to: AAo}
///     dao:   {type: windkessel, from: DAo, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
///
/// A block's flow runs from its `from` node to its `to` node and is positive along that arrow. Nodes exist by
/// being named. Unknown types, doubled names and bad parameters are refused here; what concerns the graph is
/// checked by Network. Uses of shipped subnetworks become their blocks, those of a case's own must be expanded before
/// (network/subnetwork).
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/config.hpp"

namespace ostium::lumped {
class Block;
}

namespace ostium::network {

/// A block with its name and its place in the case file.
struct Entry {
  std::string name;
  std::string where;  // "case.yaml:12:5", opens every message about the block
  std::shared_ptr<const lumped::Block> block;
};

struct Model {
  std::vector<Entry> entries;
  std::string where;  // position of the list of blocks
};

/// Reads the mapping `blocks:`; throws UserError.
Model read_model(const config::Node& blocks);

}  // namespace ostium::network
