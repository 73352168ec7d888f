/// A 0D element as the network sees it: ports, own unknowns, equations, and their exact Jacobian.
///
///   from --->[ block ]---> to        flow is positive along the arrow
///
///   own equations   0 = f_i(t, p, y, dy/dt),   one per own unknown y_i
///   port flows      q_k(t, p, y, dy/dt),       from the node of port k into the block, m3/s
///
///   p_k  Pa   pressure of the node at port k, or the fixed pressure of a grounded port
///   y_i       flows (m3/s), pressures (Pa) or volumes (m3) of the block's own; differential or algebraic
///
/// A switch (open or closed valve) is an own unknown that is 1 or 0 and has the equation 0 = dy/dt; its guard says
/// how long: a switch that is on stays on while guard >= 0, one that is off stays off while guard <= 0. The
/// integrator finds the time at which a guard passes zero and throws the switch there.
///
/// A new block is one header that declares a struct (lumped/element.hpp says what it must have), one line in
/// lumped/registry.cpp, one test. Not checked here: anything about the graph (network/graph does).
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/config/info.hpp"

namespace ostium::lumped {

enum class Quantity { pressure, flow, volume, ratio, length, velocity };

/// The size at which a quantity matters: absolute tolerances are fractions of it.
double scale_of(Quantity quantity);

/// One own unknown of a block. The quantity gives the unit of its series and the scale of its tolerance.
struct Unknown {
  const char* name = "";
  Quantity quantity = Quantity::flow;
  bool differential = false;
  bool is_switch = false;  // 0 or 1, constant between two events
};

/// An end of a block: a node, or (node empty) a ground of fixed pressure.
struct Terminal {
  std::string key;  // "from", "to": the word of the case file
  std::string node;
  double ground = 0;  // Pa
  bool grounded() const { return node.empty(); }
};

/// What a block is for the graph: how it ties two of its terminals together.
///   resistive   flow and pressure difference answer each other at once
///   capacitive  the pressure difference is a state
///   inductive   the flow is a state
///   flow, pressure   prescribed
enum class Nature { resistive, capacitive, inductive, flow, pressure };

inline constexpr int ground = -1;
struct Branch {
  int a = 0, b = ground;  // terminals
  Nature nature = Nature::resistive;
};

/// A number of a block, by its key in the case file (core/config/numbers.hpp says which there are).
struct Parameter {
  std::string key, unit;  // SI
  double value = 0;
  config::Range range = {};
};

/// Another value of the parameter of that number.
struct Change {
  int parameter = 0;
  double value = 0;
};

class Block {
 public:
  virtual ~Block() = default;

  virtual const char* type() const = 0;
  virtual const std::vector<Terminal>& terminals() const = 0;
  virtual std::span<const Unknown> unknowns() const = 0;
  virtual std::vector<Branch> branches() const = 0;

  /// x: [p, y, dy/dt] of this block; f: [own equations, port flows].
  virtual void residual(double t, const double* x, double* f) const = 0;
  /// jacobian: row-major, df_i/dx_j, (unknowns + ports) x (ports + 2 unknowns).
  virtual void jacobian(double t, const double* x, double* jacobian) const = 0;
  /// One guard per switch, in the order of the unknowns, over the scale of its quantity.
  virtual void guards(double t, const double* x, double* g) const = 0;
  /// Throws the k-th switch in the block's own unknowns y, and what must be reset with it.
  virtual void throw_switch(int k, double* y) const = 0;
  virtual int switch_count() const = 0;

  /// Start values of the differential unknowns; the others are found by the network.
  virtual void initial(double* y) const = 0;

  /// What can be changed, always in the same order.
  virtual std::vector<Parameter> parameters() const = 0;
  /// The block with other values, which are not looked at: neither ranges nor what they mean together.
  virtual std::shared_ptr<const Block> with(std::span<const Change> changes) const = 0;
  /// False where the equations jump with that parameter, so that there is no derivative with respect to it.
  virtual bool smooth_in(const std::string& parameter) const = 0;
  /// What is wrong with the parameters together, as a sentence; nothing where they are in order.
  virtual std::string refusal() const = 0;

  /// True where the Jacobian depends neither on time nor on the unknowns.
  virtual bool linear() const = 0;
  /// True where the equations do not read the time.
  virtual bool autonomous() const = 0;
  /// m3/Pa, for the comparison with the compliance of the fluid.
  virtual double compliance() const = 0;
  /// s, times in (t0, t1) at which the block's data have a kink.
  virtual std::vector<double> kinks(double t0, double t1) const = 0;
  /// m3/s, what a flow source sends; 0 for any other block.
  virtual double prescribed_flow(double t) const = 0;
  /// True where the block needs the area of an opening (a velocity instead of a flow).
  virtual bool needs_opening() const = 0;
  /// The block at an opening of that area, m2.
  virtual std::shared_ptr<const Block> at_opening(double area) const = 0;

  int port_count() const { return static_cast<int>(terminals().size()); }
  int unknown_count() const { return static_cast<int>(unknowns().size()); }
  int equation_count() const { return unknown_count() + port_count(); }
  int input_count() const { return port_count() + 2 * unknown_count(); }
};

}  // namespace ostium::lumped
