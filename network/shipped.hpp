/// The texts of network/subnetworks/*.yaml, compiled into the program.
#pragma once
#include <span>
#include <utility>

namespace ostium::network {

/// Name of the file and its content; the order of the files' names.
std::span<const std::pair<const char*, const char*>> shipped_texts();

}  // namespace ostium::network
