#include "app/checkpoint/saved_run.hpp"

#include "core/archive.hpp"

namespace ostium::app {

template <int D>
void archive(Archive& a, SavedRun<D>& saved) {
  a.part("run", [&] { coupling::archive(a, saved.run); });
  a.part("recorded", [&] { archive(a, saved.recorded); });
  a.part("account", [&] { archive(a, saved.account); });
  a.part("output", [&] { archive(a, saved.output); });
}

template void archive(Archive&, SavedRun<2>&);
template void archive(Archive&, SavedRun<3>&);

}  // namespace ostium::app
