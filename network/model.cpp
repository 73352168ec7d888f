#include "network/model.hpp"

#include "lumped/registry.hpp"
#include "network/subnetwork.hpp"

namespace ostium::network {

Model read_model(const config::Node& blocks) {
  Model model{.entries = {}, .where = blocks.where() + ": " + blocks.path()};
  if (blocks.is_null() || (blocks.is_map() && blocks.entries().empty()))
    blocks.error(
        "a network needs at least one block; write for example "
        "`dao: {{type: resistor, from: DAo, ground: 0 mmHg, R: 1e8 Pa.s/m3}}`");
  for (const auto& [name, node] : expand(blocks).entries())
    model.entries.push_back({name, node.where() + ": " + node.path(), lumped::read_block(node)});
  return model;
}

}  // namespace ostium::network
