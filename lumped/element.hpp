/// The contract of a block: what its struct must have, and the wrapper that makes a Block of it.
///
///   struct Resistor : TwoTerminal {                    // its fields are its parameters
///     double R = 0;
///     static constexpr auto type = "resistor";
///     static constexpr std::array unknowns{Unknown{"q", Quantity::flow}};
///     static constexpr Nature nature = Nature::resistive;
///     template <class T>                                // the physics, written once
///     void equations(const In<Resistor, T>& x, Out<Resistor, T>& f) const;
///     std::vector<Terminal> terminals() const;          // UserError where from/to make no sense
///   };
///   void declare(config::Fields<Resistor>&);            // names, units, ranges, documentation of the fields
///
/// Optional members, used where present: `branches()` (default: one branch of `nature` from terminal 0 to 1),
/// `initial(y)` (default 0), `compliance()`, `kinks(t0, t1)`, `prescribed_flow(t)`, `needs_opening()`,
/// `at_opening(area)`, `linear` (a constant or a function; default true) false for a block whose coefficients
/// change, `autonomous` true for a block whose equations do not read the time, `present_unknowns()` where parameters decide which unknowns are differential, `prepare()` for what is
/// computed from the parameters once, and for a block with switches `guards(in)` and, where a switch resets
/// more than itself, `reset(k, y)`. A block ties its own unknowns by as many equations; an algebraic unknown's
/// derivative must not appear in them.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/config.hpp"
#include "core/error.hpp"
#include "lumped/block.hpp"
#include "lumped/dual.hpp"

namespace ostium::lumped {

/// What the equations of block B read. Ports: From, To.
template <class B, class T>
struct In {
  double t = 0;
  std::array<T, B::ports> p{};
  std::array<T, B::unknowns.size()> y{}, dy{};
};

/// What the equations of block B give: own residuals, and the flow from each port's node into the block.
template <class B, class T>
struct Out {
  std::array<T, B::unknowns.size()> own{};
  std::array<T, B::ports> into{};
};

template <class B>
class BlockOf final : public Block {
 public:
  explicit BlockOf(B parameters) : b_(prepared(std::move(parameters))), terminals_(b_.terminals()) {
    for (int i = 0; i < own; ++i)
      if (unknowns_[i].is_switch) switches_.push_back(i);
  }

  const char* type() const override { return B::type; }
  const std::vector<Terminal>& terminals() const override { return terminals_; }
  std::span<const Unknown> unknowns() const override { return unknowns_; }

  std::vector<Branch> branches() const override {
    if constexpr (requires { b_.branches(); })
      return b_.branches();
    else
      return {{0, 1, B::nature}};
  }

  void residual(double t, const double* x, double* f) const override {
    const auto out = evaluate<double>(t, [x](int k) { return x[k]; });
    for (int i = 0; i < own; ++i) f[i] = out.own[i];
    for (int k = 0; k < B::ports; ++k) f[own + k] = out.into[k];
  }

  void jacobian(double t, const double* x, double* jacobian) const override {
    using D = Dual<inputs>;
    const auto out = evaluate<D>(t, [x](int k) { return D::variable(x[k], k); });
    for (int i = 0; i < own; ++i) write(out.own[i], jacobian + i * inputs);
    for (int k = 0; k < B::ports; ++k) write(out.into[k], jacobian + (own + k) * inputs);
  }

  void guards(double t, const double* x, double* g) const override {
    if constexpr (requires(const In<B, double>& in) { b_.guards(in); }) {
      const auto values = b_.guards(input<double>(t, [x](int k) { return x[k]; }));
      std::copy(values.begin(), values.end(), g);
    }
  }
  void throw_switch(int k, double* y) const override {
    y[switches_[k]] = 1 - y[switches_[k]];
    if constexpr (requires { b_.reset(k, y); }) b_.reset(k, y);
  }
  int switch_count() const override { return static_cast<int>(switches_.size()); }

  void initial(double* y) const override {
    for (int i = 0; i < own; ++i) y[i] = 0;
    if constexpr (requires { b_.initial(y); }) b_.initial(y);
  }

  bool linear() const override {
    if constexpr (requires { b_.linear(); })
      return b_.linear();
    else if constexpr (requires { B::linear; })
      return B::linear;
    else
      return true;
  }
  bool autonomous() const override {
    if constexpr (requires { B::autonomous; })
      return B::autonomous;
    else
      return false;
  }
  double compliance() const override {
    if constexpr (requires { b_.compliance(); })
      return b_.compliance();
    else
      return 0;
  }
  std::vector<double> kinks(double t0, double t1) const override {
    if constexpr (requires { b_.kinks(t0, t1); })
      return b_.kinks(t0, t1);
    else
      return {};
  }
  double prescribed_flow(double t) const override {
    if constexpr (requires { b_.prescribed_flow(t); })
      return b_.prescribed_flow(t);
    else
      return 0;
  }
  bool needs_opening() const override {
    if constexpr (requires { b_.needs_opening(); })
      return b_.needs_opening();
    else
      return false;
  }
  std::shared_ptr<const Block> at_opening(double area) const override {
    if constexpr (requires { b_.at_opening(area); })
      return std::make_shared<BlockOf>(b_.at_opening(area));
    else
      return std::make_shared<BlockOf>(b_);
  }

  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> all;
    B copy = b_;
    config::fields<B>().numbers(copy, "", [&](const config::NumberInfo& n, double value, const auto&) {
      all.push_back({n.key, n.unit, value, n.range});
    });
    return all;
  }
  std::shared_ptr<const Block> with(std::span<const Change> changes) const override {
    B changed = b_;
    int number = 0;
    config::fields<B>().numbers(changed, "", [&](const config::NumberInfo&, double, const auto& assign) {
      for (const auto& c : changes)
        if (c.parameter == number) assign(c.value);
      ++number;
    });
    return std::make_shared<BlockOf>(std::move(changed));
  }
  bool smooth_in(const std::string& parameter) const override {
    if constexpr (requires { b_.smooth_in(parameter); })
      return b_.smooth_in(parameter);
    else
      return true;
  }
  std::string refusal() const override { return config::fields<B>().refusal(b_); }

  const B& fields() const { return b_; }

 private:
  static constexpr int own = static_cast<int>(B::unknowns.size());
  static constexpr int inputs = B::ports + 2 * own;

  static B prepared(B parameters) {
    if constexpr (requires { parameters.prepare(); }) parameters.prepare();
    return parameters;
  }

  std::array<Unknown, B::unknowns.size()> unknowns_of() const {
    if constexpr (requires { b_.present_unknowns(); })
      return b_.present_unknowns();
    else
      return B::unknowns;
  }

  template <class T, class Read>
  In<B, T> input(double t, Read read) const {
    In<B, T> in;
    in.t = t;
    for (int k = 0; k < B::ports; ++k) in.p[k] = read(k);
    for (int i = 0; i < own; ++i) in.y[i] = read(B::ports + i);
    for (int i = 0; i < own; ++i) in.dy[i] = read(B::ports + own + i);
    return in;
  }

  template <class T, class Read>
  Out<B, T> evaluate(double t, Read read) const {
    Out<B, T> out;
    b_.equations(input<T>(t, read), out);
    return out;
  }

  template <class D>
  static void write(const D& value, double* row) {
    for (int k = 0; k < inputs; ++k) row[k] = value.d[k];
  }

  B b_;
  std::vector<Terminal> terminals_;
  std::array<Unknown, B::unknowns.size()> unknowns_ = unknowns_of();
  std::vector<int> switches_;
};

}  // namespace ostium::lumped
