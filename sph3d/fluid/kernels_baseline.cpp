#define OSTIUM_ISA baseline
#define OSTIUM_ISA_NAME "x86-64 (SSE2)"
#include "sph3d/fluid/kernels.inc"
