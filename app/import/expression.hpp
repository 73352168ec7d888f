/// A linear combination of series of a run: what another program's unknown is in terms of ours, SI.
///
///   y = constant + sum_i factor_i series_i        "p:DAo_Pa", "-1 * q:dao_m3_s", "0.001"
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ostium::app {

struct Expression {
  std::map<std::string, double> terms;  // series -> factor
  double constant = 0;

  static Expression of(const std::string& series, double factor = 1) { return {{{series, factor}}, 0}; }
  static Expression flow(const std::string& block) { return of("q:" + block + "_m3_s"); }
  static Expression pressure(const std::string& node) { return of("p:" + node + "_Pa"); }
  static Expression volume(const std::string& state) { return of("v:" + state + "_m3"); }

  double value(const std::function<double(const std::string&)>& series) const;
  /// One text per term, as a case file lists them.
  std::vector<std::string> texts() const;
  /// The inverse of `texts`; throws UserError where a factor is no number.
  static Expression parse(const std::vector<std::string>& texts);

  Expression& operator+=(const Expression& other);
  friend Expression operator+(Expression a, const Expression& b) { return a += b; }
  friend Expression operator-(Expression a, const Expression& b) { return a += -1 * b; }
  friend Expression operator*(double factor, Expression e);
};

}  // namespace ostium::app
