#include "network/system.hpp"

#include <algorithm>
#include <unordered_set>

#include "core/error.hpp"

namespace ostium::network {

namespace {

using lumped::Quantity;

std::string series_name(const std::string& block, const lumped::Unknown& u) {
  const std::string inner = std::string(u.name) == "q" ? block : block + "." + u.name;
  switch (u.quantity) {
    case Quantity::pressure:
      return "p:" + inner + "_Pa";
    case Quantity::flow:
      return "q:" + inner + "_m3_s";
    case Quantity::volume:
      return "v:" + inner + "_m3";
    case Quantity::ratio:
      return "x:" + inner;
    case Quantity::length:
      return "l:" + inner + "_m";
    case Quantity::velocity:
      return "u:" + inner + "_m_s";
  }
  return inner;
}

}  // namespace

System::System(Model model, std::vector<Port> ports, Junction junction)
    : model_(std::move(model)), ports_(std::move(ports)), graph_(make_graph(model_, ports_, junction)) {
  name_unknowns();
  place_blocks();
  make_pattern();
  prepare_linear_part();
}

void System::name_unknowns() {
  std::vector<double> scales;
  const auto add = [&](std::string name, Quantity q, bool differential, bool is_switch) {
    if (differential) differential_unknowns_.push_back(size());
    if (differential && !is_switch) states_.push_back(size());
    names_.push_back(std::move(name));
    differential_.push_back(differential);
    scales.push_back(lumped::scale_of(q));
  };
  for (const auto& node : graph_.nodes) add("p:" + node + "_Pa", Quantity::pressure, false, false);
  std::unordered_set<std::string> taken(names_.begin(), names_.end());
  for (const auto& e : model_.entries)
    for (const auto& u : e.block->unknowns()) {
      const std::string name = series_name(e.name, u);
      if (!taken.insert(name).second)
        user_error(
            "{}: the results would have two series {}; rename the block \"{}\", or the node or block whose "
            "name begins with its name",
            e.where, name, e.name);
      add(name, u.quantity, u.differential, u.is_switch);
    }
  scale_ = Eigen::Map<Eigen::VectorXd>(scales.data(), static_cast<int>(scales.size()));
}

void System::place_blocks() {
  int own = node_count();
  for (size_t i = 0; i < model_.entries.size(); ++i) {
    const auto& b = *model_.entries[i].block;
    Placed p{.block = nullptr,
             .own = own,
             .linear = false,
             .autonomous = false,
             .switches = b.switch_count(),
             .node = graph_.node_of[i],
             .ground = {},
             .row = {},
             .slots = {}};
    read(p, b);
    for (int k = 0; k < b.unknown_count(); ++k) p.row.push_back(own + k);
    for (int k = 0, n = 0; k < b.unknown_count(); ++k)
      if (b.unknowns()[k].is_switch) switches_.push_back({static_cast<int>(i), n++, own + k});
    p.row.insert(p.row.end(), p.node.begin(), p.node.end());
    own += b.unknown_count();
    linear_ = linear_ && b.linear();
    placed_.push_back(std::move(p));
  }
}

void System::read(Placed& p, const lumped::Block& block) {
  p.block = &block;
  p.linear = block.linear(), p.autonomous = block.autonomous();
  p.ground = grounds(block);
}

/// Column of a block's input [p, y, dy], outside for a ground.
int System::column(const Placed& p, int input) const {
  const int ports = p.block->port_count(), n = p.block->unknown_count();
  return input < ports ? p.node[input] : p.own + (input - ports) % n;
}

void System::make_pattern() {
  std::vector<Eigen::Triplet<double>> entries;
  const auto each = [&](auto visit) {
    for (auto& p : placed_)
      for (int e = 0; e < p.block->equation_count(); ++e)
        for (int x = 0; x < p.block->input_count(); ++x)
          if (p.row[e] != outside && column(p, x) != outside) visit(p, e, x);
  };
  each([&](Placed& p, int e, int x) { entries.emplace_back(p.row[e], column(p, x), 0.0); });
  pattern_.resize(size(), size());
  pattern_.setFromTriplets(entries.begin(), entries.end());
  pattern_.makeCompressed();
  each([&](Placed& p, int e, int x) {
    const int part = x >= p.block->port_count() + p.block->unknown_count();
    const int to = static_cast<int>(&pattern_.coeffRef(p.row[e], column(p, x)) - pattern_.valuePtr());
    p.slots.push_back({part, e * p.block->input_count() + x, to});
  });
}

/// What does not change is computed once; a nonlinear block's place is left empty.
void System::prepare_linear_part() {
  std::size_t inputs = 0, outputs = 0;
  for (const auto& p : placed_) {
    inputs = std::max<std::size_t>(inputs, p.block->input_count());
    outputs = std::max<std::size_t>(outputs, p.block->equation_count());
  }
  x_.resize(inputs), out_.resize(inputs * outputs);
  linear_d_y_.assign(pattern_.nonZeros(), 0.0), linear_d_dy_ = linear_d_y_;
  constant_forcing_.assign(size(), 0.0);
  zero_.assign(size(), 0.0);
  for (const auto& p : placed_) {
    const double* x = gather(p, zero_.data(), zero_.data());
    if (p.linear) add_jacobian(p, 0, x, linear_d_y_.data(), linear_d_dy_.data());
    if (p.autonomous) add_residual(p, 0, x, constant_forcing_.data());
  }
}

std::vector<double> System::grounds(const lumped::Block& block) {
  std::vector<double> all;
  for (const auto& end : block.terminals()) all.push_back(end.ground);
  return all;
}

const double* System::gather(const Placed& p, const std::vector<double>& ground, const double* y,
                             const double* dy) const {
  double* x = x_.data();
  for (size_t k = 0; k < p.node.size(); ++k) *x++ = p.node[k] == outside ? ground[k] : y[p.node[k]];
  const int n = static_cast<int>(p.row.size() - p.node.size());
  for (int i = 0; i < n; ++i) x[i] = y[p.own + i], x[n + i] = dy[p.own + i];
  return x_.data();
}

void System::add_residual(const Placed& p, double t, const double* x, double* f) const {
  p.block->residual(t, x, out_.data());
  for (size_t e = 0; e < p.row.size(); ++e)
    if (p.row[e] != outside) f[p.row[e]] += out_[e];
}

void System::add_jacobian(const Placed& p, double t, const double* x, double* d_y, double* d_dy) const {
  p.block->jacobian(t, x, out_.data());
  for (const auto& s : p.slots) (s.part ? d_dy : d_y)[s.to] += out_[s.from];
}

void System::subtract_port_flows(std::span<const double> port_flow, double* f) const {
  if (graph_.junction == Junction::merged) return;
  for (size_t k = 0; k < graph_.port_node.size(); ++k)
    if (graph_.port_node[k] != outside) f[graph_.port_node[k]] -= port_flow[k];
}

void System::residual(double t, const double* y, const double* dy, std::span<const double> port_flow,
                      double* f) const {
  std::fill(f, f + size(), 0.0);
  for (const auto& p : placed_) add_residual(p, t, gather(p, y, dy), f);
  subtract_port_flows(port_flow, f);
}

void System::forcing(double t, std::span<const double> port_flow, double* f) const {
  const double* driven = this->driven(t);
  for (int i = 0; i < size(); ++i) f[i] = constant_forcing_[i] + driven[i];
  subtract_port_flows(port_flow, f);
}

void System::add_driven(double t, double* f) const {
  for (const auto& p : placed_)
    if (!p.autonomous) add_residual(p, t, gather(p, zero_.data(), zero_.data()), f);
}

/// The part of the forcing that reads the time.
const double* System::driven(double t) const {
  const auto n = names_.size();
  auto& s = sources_;
  if (s.on && ++s.last < s.times.size() && s.times[s.last] == t) return &s.values[s.last * n];
  if (const auto known = s.at.find(t); known != s.at.end()) {
    s.last = known->second;
    return &s.values[s.last * n];
  }
  driven_.assign(n, 0.0);
  add_driven(t, driven_.data());
  constexpr std::size_t most = 1 << 20;  // numbers, 8 MB
  if (s.on && (s.times.size() + 1) * n <= most) {
    s.last = s.at[t] = s.times.size();
    s.times.push_back(t), s.values.insert(s.values.end(), driven_.begin(), driven_.end());
  }
  return driven_.data();
}

void System::jacobian(double t, const double* y, const double* dy, double* d_y, double* d_dy) const {
  std::copy(linear_d_y_.begin(), linear_d_y_.end(), d_y);
  std::copy(linear_d_dy_.begin(), linear_d_dy_.end(), d_dy);
  for (const auto& p : placed_)
    if (!p.linear) add_jacobian(p, t, gather(p, y, dy), d_y, d_dy);
}

void System::guards(double t, const double* y, const double* dy, double* g) const {
  for (const auto& p : placed_) {
    if (p.switches == 0) continue;
    p.block->guards(t, gather(p, y, dy), g);
    g += p.switches;
  }
}

void System::throw_switch(int k, double* y) const {
  const auto& s = switches_[k];
  placed_[s.entry].block->throw_switch(s.number, y + placed_[s.entry].own);
}

Eigen::VectorXd System::start() const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(size());
  for (const auto& p : placed_) p.block->initial(y.data() + p.own);
  for (int i = 0; i < size(); ++i)
    if (!differential_[i]) y[i] = 0;
  return y;
}

std::vector<double> System::kinks(double t0, double t1) const {
  std::vector<double> all;
  for (const auto& p : placed_) {
    const auto some = p.block->kinks(t0, t1);
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void System::replace(int entry, std::shared_ptr<const lumped::Block> block) {
  const auto now = placed_[entry].block->unknowns(), then = block->unknowns();
  const bool same = std::equal(now.begin(), now.end(), then.begin(), then.end(),
                               [](const auto& a, const auto& b) { return a.differential == b.differential; });
  if (!same)
    user_error(
        "{}: that value leaves an element of the block out, or adds one; values may be changed in a joined "
        "network "
        "where 0 stays 0 and others do not become 0",
        model_.entries[entry].where);
  if (!placed_[entry].autonomous || !block->autonomous()) sources_ = {.on = sources_.on};
  read(placed_[entry], *block);
  model_.entries[entry].block = std::move(block);
  linear_ = std::all_of(placed_.begin(), placed_.end(), [](const auto& p) { return p.linear; });
  prepare_linear_part();
}

void System::add_residual(int entry, const lumped::Block& instead, double weight, double t, const double* y,
                          const double* dy, double* f) const {
  const auto& p = placed_[entry];
  instead.residual(t, gather(p, instead, y, dy), out_.data());
  for (size_t e = 0; e < p.row.size(); ++e)
    if (p.row[e] != outside) f[p.row[e]] += weight * out_[e];
}

void System::add_guards(int entry, const lumped::Block& instead, double weight, double t, const double* y,
                        const double* dy, double* g) const {
  if (instead.switch_count() == 0) return;
  instead.guards(t, gather(placed_[entry], instead, y, dy), out_.data());
  for (int k = 0; k < switch_count(); ++k)
    if (switches_[k].entry == entry) g[k] += weight * out_[switches_[k].number];
}

double System::compliance() const {
  double sum = 0;
  for (const auto& p : placed_) sum += p.block->compliance();
  return sum;
}

double System::flow_through_opening(int port, double t, const double* y, const double* dy) const {
  double sum = 0;
  for (size_t i = 0; i < placed_.size(); ++i) {
    const auto& p = placed_[i];
    p.block->residual(t, gather(p, y, dy), out_.data());
    for (size_t k = 0; k < p.node.size(); ++k)
      if (graph_.port_of[i][k] == port) sum += out_[p.block->unknown_count() + k];
  }
  return sum;
}

}  // namespace ostium::network
