/// Ends of a block with two ports: the keys `from` and `to`, and where such a block may end.
///
///   from --->[ block ]---> to      flow positive along the arrow
///
/// Each function throws UserError with the remedy.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "lumped/block.hpp"

namespace ostium::lumped {

using Name = std::optional<std::string>;

struct TwoTerminal {
  static constexpr int ports = 2;
  enum Port { From, To };
  Name from, to;
};

template <class B>
void declare_ends(config::Fields<B>& f) {
  f.text("from", static_cast<Name B::*>(&B::from), "node its flow comes from");
  f.text("to", static_cast<Name B::*>(&B::to), "node its flow goes to");
}

/// Two nodes, or one node and an explicit ground pressure: resistor, inductor.
std::vector<Terminal> two_ends(const TwoTerminal& block, std::optional<double> ground);

/// At least one node; a missing one is a ground (of `ground` Pa where given, else 0): capacitor.
std::vector<Terminal> grounded_ends(const TwoTerminal& block, std::optional<double> ground);

/// `from` is needed; `to` may be replaced by a distal pressure (default 0): Windkessel.
std::vector<Terminal> distal_end(const TwoTerminal& block, std::optional<double> Pd);

/// At least one node; a missing one is the inexhaustible outside: sources.
std::vector<Terminal> source_ends(const TwoTerminal& block);

}  // namespace ostium::lumped
