#include "network/sweep.hpp"

#include <omp.h>

#include <atomic>
#include <cmath>
#include <exception>

#include "core/error.hpp"

namespace ostium::network {

Sweep::Sweep(const Model& model, Design design, const std::vector<Index>& indices, const StudyRun& run,
             int threads)
    : model_(model), design_(std::move(design)), indices_(indices), run_(run), studies_(threads) {
  study_of_thread(0);
}

Sweep::~Sweep() = default;

Study& Sweep::study_of_thread(int thread) {
  auto& study = studies_[static_cast<std::size_t>(thread)];
  if (!study) study = std::make_unique<Study>(model_, design_.parameters(), indices_, run_);
  return *study;
}

SampleResult Sweep::run(Study& study, std::int64_t sample) const {
  std::vector<double> values(static_cast<std::size_t>(design_.columns()));
  design_.row(sample, values);
  SampleResult s{Outcome::ok, std::vector<double>(indices_.size())};
  const auto without_result = [&](Outcome outcome, const std::exception& e) {
    s.outcome = outcome, s.reason = e.what();
    s.results.assign(indices_.size(), NAN);
  };
  try {
    study.run(values, s.results);
  } catch (const NumericsError& e) {
    without_result(Outcome::failed, e);
  } catch (const UserError& e) {
    without_result(Outcome::refused, e);
  }
  return s;
}

std::vector<SampleResult> Sweep::run(std::int64_t first, std::int64_t end, std::int64_t stride,
                                     const std::function<bool()>& stop) {
  const std::int64_t count = first < end ? (end - first + stride - 1) / stride : 0;
  std::vector<SampleResult> all(static_cast<std::size_t>(count));
  std::exception_ptr bug;  // leaves a parallel region only by hand
  std::atomic<bool> over = false;
#pragma omp parallel num_threads(static_cast <int>(studies_.size()))
  {
#pragma omp for schedule(dynamic, 1)
    for (std::int64_t i = 0; i < count; ++i) {
      if (over || stop()) continue;
      try {
        all[static_cast<std::size_t>(i)] = run(study_of_thread(omp_get_thread_num()), first + i * stride);
      } catch (...) {
#pragma omp critical(sweep_bug)
        bug = std::current_exception();
        over = true;
      }
    }
  }
  if (bug) std::rethrow_exception(bug);
  return all;
}

}  // namespace ostium::network
