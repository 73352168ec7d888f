#define OSTIUM_ISA baseline
#include "sph3d/solid/kernels.inc"
