#include "app/import/svzerod_steady.hpp"

#include "core/error.hpp"

namespace ostium::app::svzerod {

network::Network joined(const Circuit& circuit, const std::string& file, const std::string& what,
                        long most_steps) {
  try {
    const auto blocks = config::Node::parse(config::to_yaml(circuit.blocks), "its block");
    return network::Network(network::read_model(blocks), {}, {.most_steps = most_steps});
  } catch (const UserError& e) {
    user_error("{}: {} cannot be solved as it is joined: {}", file, what, e.what());
  }
}

Values run_steady_stage(const Source& source, const UnitSystem& units, const std::string& file,
                        const Tell& tell) {
  Circuit circuit(source, units, Stage::steady, nullptr);
  translate(circuit);
  constexpr long most_steps = 1000000;
  network::Network network =
      joined(circuit, file, "the network of the steady stage (\"steady_initial\")", most_steps);
  constexpr int steps = 31;
  try {
    for (int i = 0; i < steps; ++i) {
      network.advance(source.period / 10, {}, {});
      tell("steady stage", (i + 1.0) / steps);
    }
  } catch (const NumericsError& e) {
    source.root.at("simulation_parameters")
        .error(
            "the steady stage of {:.3g} s, with which a run begins unless \"steady_initial\" is false, does "
            "not end: {}; "
            "look for a C or L that is off by orders of magnitude, or set \"steady_initial\" to false",
            steps * source.period / 10, e.what());
  }
  const auto& names = network.series_names();
  std::vector<double> values(names.size());
  network.series(values);
  Values last;
  for (std::size_t i = 0; i < names.size(); ++i) last[names[i]] = values[i];
  return last;
}

}  // namespace ostium::app::svzerod
