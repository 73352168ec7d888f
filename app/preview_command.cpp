// `ostium preview`: one picture of the vessel with its named openings, the network and the size of the run.
#include <CLI/CLI.hpp>

#include "app/case_arguments.hpp"
#include "app/check.hpp"
#include "app/commands.hpp"
#include "app/estimate.hpp"
#include "core/log.hpp"
#include "lumped/block.hpp"
#include "sph3d/io/preview.hpp"

namespace ostium::app {
namespace {

/// "dao: DAo - windkessel": the column is narrow.
std::string note_of(const network::Entry& entry) {
  std::string from, to;
  for (const auto& t : entry.block->terminals()) {
    if (t.grounded()) continue;
    (t.key == "from" ? from : to) += t.node;
  }
  return fmt::format("{}: {}{}{}", entry.name, from.empty() ? "" : from + " - ", entry.block->type(),
                     to.empty() ? "" : " - " + to);
}

template <int D>
void draw(const Case& study, const std::string& title, int threads, const std::filesystem::path& png) {
  const Setup<D> s = set_up<D>(study);
  const Estimate e = estimate(study, s, calibrate<D>(threads));
  sph3d::PreviewOptions options{.title = title, .notes = {"Network"}};
  for (const auto& entry : s.model.entries) options.notes.push_back(note_of(entry));
  options.notes.insert(
      options.notes.end(),
      {"",
       fmt::format("about {} particles of {:.3g} mm", count_text(e.particles), 1e3 * study.vessel->spacing),
       fmt::format("memory about {:.2g} GB", e.memory / 1e9),
       fmt::format("run time about {} on {} cores", duration_text(e.wall), threads)});
  sph3d::preview(s.lumen, options, png);
  log::info("run time about {} on {} free cores, from a short run on this machine", duration_text(e.wall),
            threads);
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
