#include "core/archive.hpp"

#include <fmt/format.h>

namespace ostium {

void Archive::one(const std::string& name, Kind kind, void* number) {
  array(name, kind, 1, 1, [&](std::size_t n) {
    if (n != 1) misfit(name, fmt::format("{} numbers instead of one", n));
    return number;
  });
}

void Archive::operator()(const std::string& name, double& x) { one(name, Kind::real, &x); }
void Archive::operator()(const std::string& name, std::int64_t& x) { one(name, Kind::integer, &x); }

void Archive::operator()(const std::string& name, bool& x) {
  std::int64_t number = x;
  (*this)(name, number);
  x = number != 0;
}

void Archive::operator()(const std::string& name, std::string& x) {
  array(name, Kind::byte, x.size(), 1, [&](std::size_t n) {
    x.resize(n);
    return static_cast<void*>(x.data());
  });
}

}  // namespace ostium
