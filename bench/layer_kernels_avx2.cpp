#define OSTIUM_ISA avx2
#include "bench/layer_kernels.inc"
