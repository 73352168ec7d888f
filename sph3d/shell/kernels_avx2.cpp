#define OSTIUM_ISA avx2
#define OSTIUM_ISA_NAME "AVX2 + FMA"
#include "sph3d/shell/kernels.inc"
