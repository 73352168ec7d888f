/// The list of block types a case may use: reader, schema and reference of each follow from its declared
/// fields.
///
/// Adding one: its header, one line in registry.cpp, its test. Not checked here: the graph (network/graph
/// does).
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "lumped/block.hpp"

namespace ostium::lumped {

struct BlockType {
  std::string name;
  std::function<std::shared_ptr<const Block>(const config::Node&)> read;
  std::function<config::Tree(const Block&)> write;  // in SI units, defaults filled in, with its `type`
  std::function<config::Description()> describe;
};

const std::vector<BlockType>& block_types();

/// A block from its mapping {type: .., ..}; throws UserError with position, did-you-mean and remedy.
std::shared_ptr<const Block> read_block(const config::Node& node);

/// The block as a mapping that reads back to the same block.
config::Tree write_block(const Block& block);

}  // namespace ostium::lumped
