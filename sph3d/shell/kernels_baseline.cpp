#define OSTIUM_ISA baseline
#define OSTIUM_ISA_NAME "baseline x86-64"
#include "sph3d/shell/kernels.inc"
