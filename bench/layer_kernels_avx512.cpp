#define OSTIUM_ISA avx512
#include "bench/layer_kernels.inc"
