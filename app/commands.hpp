/// Commands with a file of their own: `ostium preview`, `ostium geometry`, `ostium import`, `ostium calibrate`, `ostium
/// sweep`.
#pragma once

namespace CLI {
class App;
}

namespace ostium::app {

void add_preview(CLI::App& program);
void add_geometry(CLI::App& program);
void add_import(CLI::App& program);
void add_calibrate(CLI::App& program);
void add_sweep(CLI::App& program, int& code);

}  // namespace ostium::app
