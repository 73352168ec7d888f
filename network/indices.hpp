/// Numbers that sum up a series over the last period of a run, with their derivatives.
///
///   mean S, max S, min S       of a series of network.csv
///   pulse S                    max - min
///   ejection_fraction V        (max - min)/max of a volume
///   stroke_volume V            max - min of a volume;   stroke_volume Q   int q dt of a flow, over the period
///   flow_split Q / Q0          mean of one flow over the mean of another
///
///   S   p:Ao_Pa, v:lv.V_m3, q:aortic_m3_s: the name of the series, with or without its unit
///
/// Means are integrals by three Gauss points in each step of the integrator, extremes are found where the rate of its
/// own polynomial passes zero. There the derivative is that of the series at this time; at a corner that moves (an event,
/// a shifted waveform) it is s + dy/dt dtau/dp. Not checked: that an extreme is taken at one time only.
#pragma once
#include <string>
#include <vector>

#include "network/tangent_engine.hpp"

namespace ostium::network {

struct Index {
  enum class Kind { mean, max, min, pulse, ejection_fraction, stroke_volume, flow_split };
  std::string text;
  Kind kind = Kind::mean;
  int series = 0, of = 0;  // `of`: the flow that is split
  std::string unit{};
  bool of_volume = false;  // stroke volumes: of a volume, not of a flow
};

/// Throws UserError opened by `where`, with the nearest valid word.
Index read_index(const std::string& text, const std::vector<std::string>& series, const std::string& where);

/// A value and its derivatives along the directions of a tangent.
struct Graded {
  double value = 0;
  Eigen::RowVectorXd gradient{};
};

/// Watches the series of some indices.
class IndexWatcher final : public Watcher {
 public:
  IndexWatcher(const std::vector<Index>& indices, int directions);
  void step(Interpolant& trajectory, double a, double b, bool fresh,
            const std::optional<Eigen::RowVectorXd>& tau) override;
  Graded value(const Index& index) const;

 private:
  struct Series {
    int unknown = 0;
    Graded integral, max, min;
    double before_value = 0, before_rate = 0;  // at the end of the last step, which is not offered yet
    Eigen::RowVectorXd before_s{};
  };
  void integrate(Interpolant& trajectory, double a, double b);
  void extremes(Series& s, Interpolant& trajectory, double a, double b);
  void corner(Series& s, Interpolant& trajectory, double t, const std::optional<Eigen::RowVectorXd>& tau);
  static void offer(Series& s, double value, const Eigen::RowVectorXd& gradient);
  const Series& of(int unknown) const;

  std::vector<Series> series_;
  double duration_ = 0;
  bool begun_ = false;
};

}  // namespace ostium::network
