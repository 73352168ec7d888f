#define OSTIUM_ISA avx512
#define OSTIUM_ISA_NAME "AVX-512VL, 8 lanes"
#include "sph3d/fluid/kernels.inc"
