#define OSTIUM_ISA baseline
#include "bench/layer_kernels.inc"
