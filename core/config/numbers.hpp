/// The numbers among the declared fields of a struct, by dotted key: what a sensitivity, a calibration or a sweep
/// may change.
///
///   Rd, activation.duration, cos.2      quantities and numbers as in the case file; the n-th of a list has the key n
///   flow                                a constant waveform: its value
///   flow.factor, flow.shift             any other waveform: times this, and this much later; 1 and 0 as it is given
///   flow.fourier.mean, .cos.n, .sin.n   of a Fourier series
///
/// Fields without a value (optional ones that are not given) have none. Not checked here: ranges; `range` says them.
#pragma once
#include <functional>
#include <string>

#include "core/config/info.hpp"
#include "core/waveform.hpp"

namespace ostium::config {

struct NumberInfo {
  std::string key, unit;  // SI
  Range range = {};
};

/// Called once per number; `assign` changes it in the struct that is visited.
using NumberVisitor =
    std::function<void(const NumberInfo&, double value, const std::function<void(double)>& assign)>;

void visit_waveform(Waveform& w, const FieldInfo& info, const std::string& key, const NumberVisitor& visit);

}  // namespace ostium::config
