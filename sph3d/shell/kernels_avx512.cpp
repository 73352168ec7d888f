#define OSTIUM_ISA avx512
#define OSTIUM_ISA_NAME "AVX-512"
#include "sph3d/shell/kernels.inc"
