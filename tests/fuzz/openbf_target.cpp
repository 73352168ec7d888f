#include "app/import/openbf_import.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace ostium::fuzz {

void read_openbf_text(std::string_view content) {
  if (names_other_files(content)) return;
  const std::string file = in_folder("model.yaml");
  accepted_or_refused(file, [&] { app::import_openbf(config::Node::parse(std::string(content), file), 2); });
}

}  // namespace ostium::fuzz
