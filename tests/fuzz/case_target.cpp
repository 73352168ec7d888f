#include "app/case.hpp"
#include "app/effective.hpp"
#include "network/model.hpp"
#include "network/network.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace ostium::fuzz {
namespace {

/// A case that is accepted must be accepted again as the program writes it.
void read_again(const app::Case& study, const network::Model& model, const std::string& file) {
  const std::string written = app::effective_case(study, model);
  try {
    network::read_model(app::read_case(config::Node::parse(written, file)).network.blocks);
  } catch (const UserError& e) {
    throw std::logic_error(std::string("an accepted case is refused as it is written back: ") + e.what());
  }
}

}  // namespace

void read_case_text(std::string_view content) {
  if (names_other_files(content)) return;
  const std::string file = in_folder("case.yaml");
  accepted_or_refused(file, [&] {
    const app::Case study = app::read_case(config::Node::parse(std::string(content), file));
    const network::Model model = network::read_model(study.network.blocks);
    if (!study.vessel) const network::Network joined(model);
    read_again(study, model, file);
  });
}

}  // namespace ostium::fuzz
