/// The commands that work on geometry: `ostium preview` and `ostium geometry`.
#pragma once

namespace CLI {
class App;
}

namespace ostium::app {

void add_preview(CLI::App& program);
void add_geometry(CLI::App& program);

}  // namespace ostium::app
