#include "app/effective.hpp"

#include "lumped/registry.hpp"

namespace ostium::app {
namespace {

config::Tree* find(config::Tree& map, const std::string& key) {
  return const_cast<config::Tree*>(map.find(key));  // the tree was made here, nobody else shares it
}

config::Tree blocks_of(const network::Model& model) {
  config::Tree blocks = config::Tree::map();
  for (const auto& entry : model.entries) blocks.add(entry.name, lumped::write_block(*entry.block));
  return blocks;
}

}  // namespace

std::string effective_case(const Case& study, const network::Model& model) {
  Case resolved = study;
  resolved.network.initial = study.initial(), resolved.network.periodic.reset();
  config::Tree tree = config::write(resolved);
  *find(*find(tree, "network"), "blocks") = blocks_of(model);
  if (study.vessel && study.vessel->outline && study.vessel->outline->is_scalar())
    *find(*find(tree, "vessel"), "outline") =
        config::write_path(config::read_path(*study.vessel->outline, {}));
  return config::to_yaml(tree);
}

}  // namespace ostium::app
