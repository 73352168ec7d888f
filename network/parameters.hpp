/// The numbers of a network's blocks that a sensitivity, a calibration or a sweep may change, by name.
///
///   body.Rd, lv.activation.duration, heart.flow.factor      block.key, the key as in the case file
///
///   value    SI, as the case gives it
///   unit     SI unit, "1" for numbers
///   range    what the block allows
///   size     |value|, or where that is 0 what such a quantity has in the circulation: sensitivities are scaled by it
///
/// Optional keys that the case does not give have no value to change. Not checked: that a change keeps the network solvable.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "lumped/block.hpp"
#include "network/model.hpp"

namespace ostium::network {

struct Parameter {
  std::string name, unit;
  double value = 0, size = 1;
  config::Range range = {};
  int entry = 0, number = 0;  // block of the model, parameter of the block
};

/// All of them, in the order of the blocks.
std::vector<Parameter> parameters(const Model& model);

/// The one of that name; throws UserError with the nearest valid name, opened by `where`.
Parameter parameter(const Model& model, const std::string& name, const std::string& where);

/// Throws UserError where the value is not finite or outside the range of the parameter.
void check_value(const Parameter& parameter, double value);

/// A block that takes the place of an entry of the model.
struct Replacement {
  int entry = 0;
  std::shared_ptr<const lumped::Block> block;
};

/// Values that differ from those of the case, and the blocks that have them. Setting a parameter again replaces its
/// value; what was set of other parameters stays.
class Changes {
 public:
  explicit Changes(Model as_given) : given_(std::move(as_given)), changes_(given_.entries.size()) {}

  /// The entry's block with this value and those kept before. Throws UserError: range, or what the block refuses.
  std::shared_ptr<const lumped::Block> block(const Parameter& parameter, double value) const;
  void keep(const Parameter& parameter, double value);

  /// The blocks with all of these values at once, each with those kept before: only the values together must make sense.
  /// Throws UserError as `block`.
  std::vector<Replacement> blocks(const std::vector<Parameter>& parameters,
                                  std::span<const double> values) const;

 private:
  std::vector<lumped::Change> with(const Parameter& parameter, double value) const;
  Model given_;
  std::vector<std::vector<lumped::Change>> changes_;  // per entry
};

}  // namespace ostium::network
