#include "app/import/openbf_import.hpp"

#include <algorithm>

#include "app/import/check_imported.hpp"
#include "app/import/openbf_walls.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace openbf {
namespace {

using config::Tree;

Tree text(const std::string& t) { return Tree::scalar(t); }
Tree measured(double value, const std::string& unit) { return text(shortest(value) + " " + unit); }
std::string node(int n) { return "n" + std::to_string(n); }

Tree list(const std::vector<double>& values) {
  Tree all = Tree::list();
  for (const double v : values) all.items.push_back(std::make_shared<Tree>(text(shortest(v))));
  return all;
}

class Circuit {
 public:
  Circuit(const Source& source, int pieces)
      : source_(source), pieces_(pieces), steady_(steady_state(source)) {}

  Tree blocks() {
    inflow();
    for (std::size_t i = 0; i < source_.vessels.size(); ++i) {
      for (int k = 0; k < pieces_; ++k) piece(i, k);
      if (source_.vessels[i].R1 || source_.vessels[i].Rt) outflow(i);
    }
    return std::move(blocks_);
  }
  const Steady& steady() const { return steady_; }

 private:
  void inflow() {
    Tree flow = Tree::map();
    flow.add("times", list(source_.times)).add("time_unit", text("s"));
    flow.add("values", list(source_.flow)).add("unit", text("m3/s"));
    flow.add("period", measured(source_.period(), "s"));
    Tree t = Tree::map();
    t.add("type", text("flow_source")).add("to", text(node(source_.inlet))).add("flow", std::move(flow));
    blocks_.add("inlet", std::move(t));
  }

  std::string name(std::size_t i, int k) const {
    const auto& label = source_.vessels[i].label;
    return pieces_ == 1 ? label : label + "." + std::to_string(k + 1);
  }

  void piece(std::size_t i, int k) {
    const auto& v = source_.vessels[i];
    const double share = 1.0 / pieces_, p = steady_.pressure[i];
    const auto [R, L, C] = lumped(v, source_.blood, p, k * share, (k + 1) * share);
    Tree t = Tree::map();
    t.add("type", text("vessel"));
    t.add("from", text(k == 0 ? node(v.sn) : name(i, k - 1)));
    t.add("to", text(k + 1 == pieces_ ? node(v.tn) : name(i, k)));
    t.add("R", measured(R, "Pa.s/m3")).add("C", measured(C, "m3/Pa")).add("L", measured(L, "Pa.s2/m3"));
    t.add("initial_pressure", measured(p, "Pa")).add("initial_flow", measured(steady_.flow[i], "m3/s"));
    blocks_.add(name(i, k), std::move(t));
  }

  void outflow(std::size_t i) {
    const auto& v = source_.vessels[i];
    const Outlet o = outlet(v, source_.blood, steady_.pressure[i]);
    Tree t = Tree::map();
    t.add("type", text(o.Cc > 0 ? "windkessel" : "resistor")).add("from", text(node(v.tn)));
    if (o.Cc > 0) {
      t.add("Rp", measured(o.R1, "Pa.s/m3"))
          .add("C", measured(o.Cc, "m3/Pa"))
          .add("Rd", measured(o.R2, "Pa.s/m3"));
      t.add("initial_pressure", measured(steady_.end[i] - o.R1 * steady_.flow[i], "Pa"));
    } else {
      t.add("R", measured(o.R1, "Pa.s/m3")).add("ground", measured(o.ground, "Pa"));
    }
    blocks_.add(v.label + ".outlet", std::move(t));
  }

  const Source& source_;
  int pieces_;
  Steady steady_;
  Tree blocks_ = Tree::map();
};

}  // namespace
}  // namespace openbf

ImportedOpenbf import_openbf(const std::filesystem::path& file, int pieces) {
  return import_openbf(config::Node::load(file), pieces);
}

ImportedOpenbf import_openbf(const config::Node& model, int pieces) {
  using namespace openbf;
  const std::filesystem::path file = model.file();
  ImportedOpenbf made;
  const Source source = read_source(model, made.notes);
  if (source.vessels.size() * static_cast<std::size_t>(pieces) > 100000)
    model.error("{} vessels in {} pieces each are too many; at most 100000 blocks are made",
                source.vessels.size(), pieces);
  Circuit circuit(source, pieces);
  Tree blocks = circuit.blocks(), network = Tree::map(), time = Tree::map(), all = Tree::map();
  made.vessels = source.vessels.size(), made.blocks = blocks.entries.size();
  const auto [low, high] =
      std::minmax_element(circuit.steady().pressure.begin(), circuit.steady().pressure.end());
  made.lowest = *low, made.highest = *high;
  network.add("initial", text("rest")).add("blocks", std::move(blocks));
  time.add("period", measured(source.period(), "s")).add("cycles", text("10"));
  Tree output = Tree::map();
  output.add("every", measured(source.period() / 200, "s"));
  all.add("title", text(source.name)).add("network", std::move(network)).add("time", std::move(time));
  all.add("output", std::move(output));
  made.yaml = "# Imported from " + file.filename().string() + " of openBF\n" + config::to_yaml(all);
  check_imported(made.yaml, file);
  return made;
}

}  // namespace ostium::app
