#include "app/import/svzerod_import.hpp"

#include "app/import/check_imported.hpp"
#include "app/import/svzerod_cycles.hpp"
#include "app/import/svzerod_steady.hpp"
#include "app/import/svzerod_units.hpp"
#include "core/units.hpp"

namespace ostium::app {

using config::Tree;

namespace svzerod {
namespace {

Tree text(const std::string& t) { return Tree::scalar(t); }

/// That program's first row is the start as the file gives it, consistent or not.
Tree first_row(const Source& source, const Tree& variables) {
  Tree t = Tree::map();
  for (const auto& v : variables.entries)
    if (const double value = source.start(v.key); value != 0) t.add(v.key, text(shortest(value)));
  return t;
}

Tree output(const Source& source, const Circuit& circuit, int cycles) {
  const double every = source.period / (source.run.points - 1) * source.run.interval;
  Tree back = Tree::map();
  back.add("cycles", text(source.run.all_cycles ? "all" : "last"));
  if (source.run.mean_only) back.add("mean_only", text("true"));
  const bool from_start = source.run.all_cycles || cycles == 1;
  if (from_start && !source.run.steady_initial) back.add("start", first_row(source, circuit.variables()));
  back.add("variables", circuit.variables());
  Tree t = Tree::map();
  t.add("every", text(UnitSystem::text(every, "s")));
  if (!source.run.all_cycles && cycles > 1)
    t.add("from", text(UnitSystem::text((cycles - 1) * source.period, "s")));
  t.add("svzerod", std::move(back));
  return t;
}

Tree case_of(const Source& source, const Circuit& circuit, int cycles) {
  Tree network = Tree::map(), time = Tree::map(), all = Tree::map();
  network.add("initial", text("rest")).add("blocks", circuit.blocks);
  time.add("period", text(UnitSystem::text(source.period, "s"))).add("cycles", text(std::to_string(cycles)));
  all.add("title", text(source.title)).add("network", std::move(network)).add("time", std::move(time));
  all.add("output", output(source, circuit, cycles));
  return all;
}

}  // namespace
}  // namespace svzerod

Imported import_svzerod(const std::filesystem::path& file, const std::optional<std::string>& units,
                        const svzerod::Tell& tell) {
  return import_svzerod(JsonNode::load(file), file, units, tell);
}

Imported import_svzerod(const JsonNode& model, const std::filesystem::path& file,
                        const std::optional<std::string>& units, const svzerod::Tell& tell) {
  using namespace svzerod;
  Imported result;
  Source source = read_source(model, result.notes);
  source.title = file.stem().string();
  std::tie(result.units, result.why_units) =
      units ? std::pair(*units, std::string("as told")) : guess_units(source);
  const UnitSystem& system = UnitSystem::of(result.units);

  std::optional<Values> steady;
  if (source.run.steady_initial) steady = run_steady_stage(source, system, file.string(), tell);
  Circuit circuit(source, system, Stage::run, steady ? &*steady : nullptr);
  translate(circuit);
  constexpr long most_steps = 20000000;
  const int cycles =
      cycles_of(source, circuit, joined(circuit, file.string(), "the network", most_steps), tell);
  const Tree made = case_of(source, circuit, cycles);
  result.yaml =
      "# Imported from " + file.filename().string() + ", units " + system.name + "\n" + config::to_yaml(made);
  check_imported(result.yaml, file);
  result.blocks = circuit.blocks.entries.size();
  result.variables = circuit.variables().entries.size();
  return result;
}

}  // namespace ostium::app
