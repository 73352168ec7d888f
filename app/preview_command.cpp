// `ostium preview`: one picture of the vessel with its named openings, the network and the size of the run.
#include <CLI/CLI.hpp>

#include "app/case_arguments.hpp"
#include "app/check.hpp"
#include "app/commands.hpp"
#include "app/estimate.hpp"
#include "core/log.hpp"
#include "sph3d/io/preview.hpp"

namespace ostium::app {
namespace {

template <int D>
void draw(const Case& study, const std::string& title, int threads, const std::filesystem::path& png) {
  const Setup<D> s = set_up<D>(study);
  const Estimate e = estimate(study, s, threads);
  sph3d::PreviewOptions options{.title = title, .notes = network_lines(s.model)};
  options.notes.insert(options.notes.begin(), "Network");
  options.notes.push_back("");
  for (const auto& line : estimate_lines(study, e, threads)) options.notes.push_back(line);
  sph3d::preview(s.lumen, options, png);
  log::info("written to {}", png.string());
}

}  // namespace

void add_preview(CLI::App& program) {
  auto* command =
      program.add_subcommand("preview", "draw the vessel, its named openings and the network into one PNG");
  struct Arguments : CaseArguments {
    std::string output;
  };
  auto a = std::make_shared<Arguments>();
  a->add_to(*command);
  command->add_option("-o,--output", a->output, "picture; default: CASE.png");
  command->callback([a] {
    const Case study = a->read();
    if (!study.vessel)
      study.origin.error(
          "a case without \"vessel\" has no geometry to draw; \"ostium check\" lists its network");
    const std::string name = case_name(a->file), title = study.title.empty() ? name : study.title;
    const std::filesystem::path png = a->output.empty() ? name + ".png" : a->output;
    study.vessel->dimension == 2 ? draw<2>(study, title, a->thread_count(), png)
                                 : draw<3>(study, title, a->thread_count(), png);
  });
}

}  // namespace ostium::app
