/// Many runs of one network with other values of its parameters, on all cores.
///
/// Each thread has a study of its own (network/study), joined once. What a sample gives depends neither on the threads nor
/// on the order in which they take the samples. A sample that fails keeps nobody from going on.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "network/design.hpp"
#include "network/study.hpp"

namespace ostium::network {

/// refused: the values together are not what a block allows; failed: the run has no result; open: not run.
enum class Outcome : std::uint8_t { ok, failed, refused, open };

struct SampleResult {
  Outcome outcome = Outcome::open;
  std::vector<double> results = {};  // one per index, SI; not a number where the outcome is not ok
  std::string reason = {};           // why it is not ok
};

class Sweep {
 public:
  /// Throws UserError where a single study would.
  Sweep(const Model& model, Design design, const std::vector<Index>& indices, const StudyRun& run,
        int threads);
  ~Sweep();

  const Design& design() const { return design_; }

  /// The samples first, first + stride, .. below end, in this order. As soon as `stop` says so, what has not begun stays
  /// open.
  std::vector<SampleResult> run(std::int64_t first, std::int64_t end, std::int64_t stride,
                                const std::function<bool()>& stop);

 private:
  SampleResult run(Study& study, std::int64_t sample) const;
  Study& study_of_thread(int thread);

  Model model_;
  Design design_;
  std::vector<Index> indices_;
  StudyRun run_;
  std::vector<std::unique_ptr<Study>> studies_;  // one per thread
};

}  // namespace ostium::network
