#include "app/import/check_imported.hpp"

#include "app/case.hpp"
#include "network/model.hpp"
#include "network/network.hpp"

namespace ostium::app {

void check_imported(const std::string& yaml, const std::filesystem::path& model) {
  try {
    const Case study = read_case(config::Node::parse(yaml, "its case"));
    const network::Network joined(network::read_model(study.network.blocks));
  } catch (const UserError& e) {
    user_error("{}: what it says makes no case that could run: {}", model.string(), e.what());
  }
}

}  // namespace ostium::app
