/// The differential-algebraic equations of a joined network, with their exact Jacobian.
///
///   F(t, y, dy/dt; Q) = 0,   y = [node pressures, own unknowns of block 1, of block 2, ..]
///
///   row of a node      sum of the flows into its blocks - sum of the port flows Q_k there = 0     m3/s
///   rows of a block    its own equations
///   J                  dF/dy + c_j dF/d(dy/dt), one sparsity pattern for both parts
///
/// Unknowns are SI; `scale` gives the size at which each matters (100 mmHg, 100 mL/s, 100 mL).
/// One thread at a time may ask a System: it keeps memory between calls. Not checked: the graph (network/graph
/// does).
#pragma once
#include <Eigen/SparseCore>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "lumped/block.hpp"
#include "network/graph.hpp"

namespace ostium::network {

class System {
 public:
  System(Model model, std::vector<Port> ports, Junction junction = Junction::separate);

  int size() const { return static_cast<int>(names_.size()); }
  int node_count() const { return static_cast<int>(graph_.nodes.size()); }
  const std::vector<std::string>& names() const { return names_; }
  const Eigen::VectorXd& scale() const { return scale_; }
  bool differential(int i) const { return differential_[i]; }
  const std::vector<int>& differential_unknowns() const { return differential_unknowns_; }
  /// The differential unknowns without the switches: what a trajectory starts from.
  const std::vector<int>& states() const { return states_; }
  bool linear() const { return linear_; }

  /// port_flow: one per port, entries of flow ports are ignored.
  void residual(double t, const double* y, const double* dy, std::span<const double> port_flow,
                double* f) const;

  /// The residual at y = 0, dy/dt = 0: what drives a linear network.
  void forcing(double t, std::span<const double> port_flow, double* f) const;

  /// From now on keeps what the sources gave at each time, for runs that ask again for the same times.
  void remember_sources() { sources_.on = true; }

  int switch_count() const { return static_cast<int>(switches_.size()); }
  bool on(int k, const double* y) const { return y[switches_[k].unknown] > 0.5; }
  /// One per switch: >= 0 while it may stay on, <= 0 while it may stay off (lumped/block.hpp).
  void guards(double t, const double* y, const double* dy, double* g) const;
  void throw_switch(int k, double* y) const;
  const std::string& switch_name(int k) const { return names_[switches_[k].unknown]; }

  /// Pattern of the Jacobian (compressed columns) and its two parts on it.
  const Eigen::SparseMatrix<double>& pattern() const { return pattern_; }
  void jacobian(double t, const double* y, const double* dy, double* d_y, double* d_dy) const;

  /// y at rest: start values of the differential unknowns, else 0.
  Eigen::VectorXd start() const;

  std::vector<double> kinks(double t0, double t1) const;
  double compliance() const;
  /// Flow from the vessel through port k into the blocks there, in a merged network.
  double flow_through_opening(int port, double t, const double* y, const double* dy) const;

  /// Puts a block with other parameters in the place of an entry: same ends, same unknowns. Throws UserError where the
  /// parameters decide otherwise which unknowns are differential.
  void replace(int entry, std::shared_ptr<const lumped::Block> block);
  /// Adds weight times what the equations (the guards) were with `instead` in the place of that entry.
  void add_residual(int entry, const lumped::Block& instead, double weight, double t, const double* y,
                    const double* dy, double* f) const;
  void add_guards(int entry, const lumped::Block& instead, double weight, double t, const double* y,
                  const double* dy, double* g) const;
  /// Index of the first own unknown of an entry.
  int own(int entry) const { return placed_[entry].own; }

  const std::vector<Port>& ports() const { return ports_; }
  const Graph& graph() const { return graph_; }
  const Model& model() const { return model_; }

 private:
  struct Slot {
    int part, from, to;  // 0: d_y, 1: d_dy; index in the block's Jacobian; index in the pattern's values
  };
  struct Placed {
    const lumped::Block* block;
    int own;  // index of its first own unknown
    bool linear, autonomous;
    int switches;
    std::vector<int> node;  // per terminal
    std::vector<double> ground;
    std::vector<int> row;  // per equation, outside where dropped
    std::vector<Slot> slots;
  };

  struct Switch {
    int entry, number, unknown;
  };

  void name_unknowns();
  void place_blocks();
  void make_pattern();
  void prepare_linear_part();
  void read(Placed& p, const lumped::Block& block);
  const double* gather(const Placed& p, const double* y, const double* dy) const {
    return gather(p, p.ground, y, dy);
  }
  const double* gather(const Placed& p, const std::vector<double>& ground, const double* y,
                       const double* dy) const;
  const double* gather(const Placed& p, const lumped::Block& instead, const double* y,
                       const double* dy) const {
    return gather(p, grounds(instead), y, dy);
  }
  static std::vector<double> grounds(const lumped::Block& block);
  void add_residual(const Placed& p, double t, const double* x, double* f) const;
  void add_jacobian(const Placed& p, double t, const double* x, double* d_y, double* d_dy) const;
  void subtract_port_flows(std::span<const double> port_flow, double* f) const;
  int column(const Placed& p, int input) const;

  Model model_;
  std::vector<Port> ports_;
  Graph graph_;
  std::vector<Placed> placed_;
  std::vector<std::string> names_;
  std::vector<bool> differential_;
  std::vector<int> differential_unknowns_, states_;
  std::vector<Switch> switches_;
  Eigen::VectorXd scale_;
  Eigen::SparseMatrix<double> pattern_;
  bool linear_ = true;
  /// Of the blocks whose Jacobian is constant, and of those that do not read the time.
  std::vector<double> linear_d_y_, linear_d_dy_, constant_forcing_, zero_;
  const double* driven(double t) const;
  void add_driven(double t, double* f) const;
  mutable std::vector<double> x_, out_, driven_;  // of one block and of the sources, kept for their memory
  /// What sources gave, in the order in which it was first asked for: most runs ask in the same order again.
  struct Remembered {
    bool on = false;
    std::vector<double> times{}, values{};  // size() values per time
    std::unordered_map<double, std::size_t> at{};
    std::size_t last = 0;
  };
  mutable Remembered sources_;
};

}  // namespace ostium::network
