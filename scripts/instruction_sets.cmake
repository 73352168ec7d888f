# Kernels are written once, in x.inc, and compiled once per instruction set, from x_baseline.cpp, x_avx2.cpp and
# x_avx512.cpp; sph3d/fluid/instruction_set.hpp chooses among them. The inlining limits keep g++ from calling the small
# vector functions of the large loops out of line. AVX-512 is used for its 32 registers and broadcasting operands, with the
# same eight lanes as AVX2: wider vectors waste more lanes than they save instructions.
option(OSTIUM_BASELINE_ONLY "Kernels for baseline x86-64 only, no AVX" OFF)
if(OSTIUM_BASELINE_ONLY)
  add_compile_definitions(OSTIUM_BASELINE_ONLY)
endif()

# Removes from the list `sources` what is not to be compiled, and gives the rest of x_*.cpp its flags.
macro(per_instruction_set x)
  set(kernel_flags -O3 -fno-math-errno -fno-trapping-math -fschedule-insns -fsched-pressure
                   --param=inline-unit-growth=10000 --param=large-function-growth=100000)
  set(flags_baseline "")
  set(flags_avx2 -mavx2 -mfma)
  set(flags_avx512 ${flags_avx2} -mavx512f -mavx512vl -mavx512dq -mavx512bw -mprefer-vector-width=256
      -Wno-maybe-uninitialized)  # g++ 12 warns of its own intrinsics
  if(OSTIUM_BASELINE_ONLY)
    list(FILTER sources EXCLUDE REGEX "/${x}_avx")
  endif()
  foreach(isa baseline avx2 avx512)
    set_source_files_properties(${x}_${isa}.cpp PROPERTIES COMPILE_OPTIONS "${kernel_flags};${flags_${isa}}"
                                OBJECT_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${x}.inc")
  endforeach()
endmacro()
