#include "lumped/registry.hpp"

#include "core/did_you_mean.hpp"
#include "lumped/capacitor.hpp"
#include "lumped/coronary.hpp"
#include "lumped/elastance_chamber.hpp"
#include "lumped/exponential_chamber.hpp"
#include "lumped/flow_source.hpp"
#include "lumped/impedance.hpp"
#include "lumped/inductor.hpp"
#include "lumped/orifice_valve.hpp"
#include "lumped/pressure_source.hpp"
#include "lumped/rc.hpp"
#include "lumped/resistor.hpp"
#include "lumped/smooth_valve.hpp"
#include "lumped/sphere_chamber.hpp"
#include "lumped/structured_tree.hpp"
#include "lumped/valve.hpp"
#include "lumped/vessel.hpp"
#include "lumped/windkessel.hpp"

namespace ostium::lumped {

namespace {

/// Parameters come with their positions; what the struct says about its ends gets the block's.
template <class B>
std::shared_ptr<const Block> read(const config::Node& node) {
  B parameters = config::read<B>(node, {"type"});
  try {
    return std::make_shared<BlockOf<B>>(std::move(parameters));
  } catch (const UserError& e) {
    node.error("the {} {}", B::type, e.what());
  }
}

template <class B>
config::Tree write(const Block& block) {
  config::Tree tree = config::Tree::map();
  tree.add("type", config::Tree::scalar(B::type));
  for (auto& entry : config::write(dynamic_cast<const BlockOf<B>&>(block).fields()).entries)
    tree.add(entry.key, *entry.value);
  return tree;
}

template <class B>
BlockType entry() {
  return {B::type, read<B>, write<B>, config::describe<B>};
}

const BlockType* find(const std::string& name) {
  for (const auto& type : block_types())
    if (type.name == name) return &type;
  return nullptr;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& type : block_types()) all.push_back(type.name);
  return all;
}

}  // namespace

const std::vector<BlockType>& block_types() {
  static const std::vector<BlockType> types{
      entry<Resistor>(),
      entry<Capacitor>(),
      entry<Inductor>(),
      entry<Vessel>(),
      entry<Rc>(),
      entry<Windkessel>(),
      entry<StructuredTree>(),
      entry<Impedance>(),
      entry<Coronary>(),
      entry<ElastanceChamber>(),
      entry<ExponentialChamber>(),
      entry<SphereChamber>(),
      entry<Valve>(),
      entry<SmoothValve>(),
      entry<OrificeValve>(),
      entry<FlowSource>(),
      entry<PressureSource>(),
  };
  return types;
}

std::shared_ptr<const Block> read_block(const config::Node& node) {
  const config::Node type = node.at("type");
  if (const BlockType* found = find(type.text())) return found->read(node);
  type.error("there is no block type \"{}\"{}", type.text(), did_you_mean(type.text(), names()));
}

config::Tree write_block(const Block& block) { return find(block.type())->write(block); }

}  // namespace ostium::lumped
