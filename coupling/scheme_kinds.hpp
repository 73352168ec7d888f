/// The schemes behind make_scheme, one file each.
#pragma once
#include "coupling/scheme.hpp"

namespace ostium::coupling {

std::unique_ptr<Scheme> make_held();
std::unique_ptr<Scheme> make_extrapolated();
std::unique_ptr<Scheme> make_linearised();
std::unique_ptr<Scheme> make_modified_euler(const network::Network& network);

/// Laws that hold the network's present pressures; the start of every explicit scheme.
Laws held_pressures(const network::Network& network);

}  // namespace ostium::coupling
