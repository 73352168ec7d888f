/// Commands with a file of their own: `ostium preview`, `ostium geometry`, `ostium import`, `ostium calibrate`.
#pragma once

namespace CLI {
class App;
}

namespace ostium::app {

void add_preview(CLI::App& program);
void add_geometry(CLI::App& program);
void add_import(CLI::App& program);
void add_calibrate(CLI::App& program);

}  // namespace ostium::app
