#include "app/import/svzerod_calibration.hpp"
#include "app/import/svzerod_import.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace ostium::fuzz {

void read_svzerod_text(std::string_view content) {
  // to run until cycles agree takes seconds
  if (content.find("use_cycle_to_cycle_error") != std::string_view::npos) return;
  const std::string file = "model.json";
  accepted_or_refused(file, [&] {
    const auto model = app::JsonNode::parse(std::string(content), file);
    if (app::has_observations(model)) app::calibrate_svzerod(model);
    app::import_svzerod(model, file);
  });
}

}  // namespace ostium::fuzz
