#define OSTIUM_ISA avx512
#include "sph3d/solid/kernels.inc"
