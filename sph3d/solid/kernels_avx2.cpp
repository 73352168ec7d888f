#define OSTIUM_ISA avx2
#include "sph3d/solid/kernels.inc"
