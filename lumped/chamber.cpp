#include "lumped/chamber.hpp"

namespace ostium::lumped {

std::vector<Terminal> ChamberEnds::terminals() const {
  if (!from) user_error("has no `from`; name the node the chamber is at");
  if (to && L == 0)
    user_error(
        "has a `to` but no inertance `L` between its two nodes; give L, or let the valve begin at \"{}\"",
        *from);
  if (!to && L > 0) user_error("has an inertance `L` but no node `to` behind it; name that node, or drop L");
  return grounded_ends(*this, std::nullopt);
}

std::vector<Branch> ChamberEnds::branches() const {
  std::vector<Branch> all{{From, lumped::ground, Nature::capacitive}};
  if (to) all.push_back({From, To, Nature::inductive});
  return all;
}

}  // namespace ostium::lumped
