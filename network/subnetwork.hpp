/// Named subnetworks: a part of a network, defined once and used as a block.
///
///   network:
///     subnetworks:
///       bed:
///         ports: [artery, vein]                            # nodes inside that the outside is joined to
///         parameters: {R: {unit: Pa.s/m3, default: 1.2e8 Pa.s/m3, doc: resistance}, C: {unit: m3/Pa}}
///         blocks:
///           arteries: {type: vessel, from: artery, to: mid, R: 0.1 * $R, C: $C, order: CRL}
///           rest:     {type: resistor, from: mid, to: vein, R: 0.9 * $R}
///     blocks:
///       body: {type: bed, artery: Ao, vein: V, C: 1e-8 m3/Pa}
///
/// A use is replaced by the blocks of the definition. The block `arteries` inside `body` becomes `body.arteries`, the
/// node `mid` becomes `body.mid` (other blocks may name it so), the node `artery` is the node `Ao`. `$R` is the value
/// of a parameter; sums, differences, products and quotients of parameters and plain numbers are evaluated with their
/// units. A key with a dot reaches inside: `rest.R: 2e8 Pa.s/m3` replaces the R of `rest` for this use.
/// Subnetworks may use each other. Shipped ones (network/subnetworks/*.yaml) are always there.
///
/// What a definition and a use may get wrong is refused with both positions. Not checked: the parts of a definition
/// that nobody uses.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/config.hpp"

namespace ostium::network {

struct SubnetworkParameter {
  std::string unit;
  std::optional<std::string> value;  // the default, with its unit
  std::string doc;
  config::Node origin;
};
void declare(config::Fields<SubnetworkParameter>&);

struct Subnetwork {
  std::string doc, source;
  config::Node ports;  // [name, ..] or {name: meaning, ..}
  std::vector<std::pair<std::string, SubnetworkParameter>> parameters;
  config::Node blocks;
  config::Node origin;

  std::vector<std::string> port_names() const;
  std::string port_doc(const std::string& port) const;
};
void declare(config::Fields<Subnetwork>&);

using Subnetworks = std::vector<std::pair<std::string, Subnetwork>>;

/// Those compiled into the program.
const Subnetworks& shipped_subnetworks();

/// The mapping `blocks:` with every use of a subnetwork replaced by its blocks; throws UserError. `definitions` is the
/// mapping `subnetworks:` of the case.
config::Node expand(const config::Node& blocks, const std::optional<config::Node>& definitions = {});

}  // namespace ostium::network
