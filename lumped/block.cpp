#include "lumped/block.hpp"

namespace ostium::lumped {

double scale_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::pressure:
      return 13332.2;  // 100 mmHg
    case Quantity::flow:
    case Quantity::volume:
      return 1e-4;  // 100 mL/s, 100 mL
    case Quantity::ratio:
      return 1;
    case Quantity::length:
      return 0.01;
    case Quantity::velocity:
      return 0.1;
  }
  return 1;
}

}  // namespace ostium::lumped
