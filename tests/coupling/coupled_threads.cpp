// Small vessels run best on one thread, beside other tests; who tests several threads asks for them.
#include <gtest/gtest.h>
#include <omp.h>

namespace {

struct OneThread : testing::Environment {
  void SetUp() override { omp_set_num_threads(1); }
};
const auto* const one_thread = testing::AddGlobalTestEnvironment(new OneThread);

}  // namespace
