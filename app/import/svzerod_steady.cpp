#include "app/import/svzerod_steady.hpp"

namespace ostium::app::svzerod {

network::Network joined(const Circuit& circuit, const std::string& file, const std::string& what) {
  try {
    const auto blocks = config::Node::parse(config::to_yaml(circuit.blocks), "its block");
    return network::Network(network::read_model(blocks));
  } catch (const UserError& e) {
    user_error("{}: {} cannot be solved as it is joined: {}", file, what, e.what());
  }
}

Values run_steady_stage(const Source& source, const UnitSystem& units, const std::string& file) {
  Circuit circuit(source, units, Stage::steady, nullptr);
  translate(circuit);
  network::Network network = joined(circuit, file, "the network of the steady stage (\"steady_initial\")");
  constexpr int steps = 31;
  for (int i = 0; i < steps; ++i) network.advance(source.period / 10, {}, {});
  const auto& names = network.series_names();
  std::vector<double> values(names.size());
  network.series(values);
  Values last;
  for (std::size_t i = 0; i < names.size(); ++i) last[names[i]] = values[i];
  return last;
}

}  // namespace ostium::app::svzerod
