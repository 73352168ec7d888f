/// Which of the kernels' instruction sets is used: scripts/instruction_sets.cmake compiles them.
///
///     OSTIUM_DECLARE_PER_ISA(const Table& table())      declares baseline::table, avx2::table, avx512::table
///     OSTIUM_FOR_THIS_PROCESSOR(table())                calls the best of them that the processor can run
#pragma once

namespace ostium::sph3d {

enum class InstructionSet { baseline, avx2, avx512 };

/// The best there is, or what the environment variable OSTIUM_ISA ("baseline", "avx2") limits it to, for comparisons.
InstructionSet instruction_set();

}  // namespace ostium::sph3d

#define OSTIUM_DECLARE_PER_ISA(...) \
  namespace baseline {              \
  __VA_ARGS__;                      \
  }                                 \
  namespace avx2 {                  \
  __VA_ARGS__;                      \
  }                                 \
  namespace avx512 {                \
  __VA_ARGS__;                      \
  }

#ifdef OSTIUM_BASELINE_ONLY
#define OSTIUM_FOR_THIS_PROCESSOR(call) baseline::call
#else
#define OSTIUM_FOR_THIS_PROCESSOR(call)                       \
  (instruction_set() == InstructionSet::avx512 ? avx512::call \
   : instruction_set() == InstructionSet::avx2 ? avx2::call   \
                                               : baseline::call)
#endif
