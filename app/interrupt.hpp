/// SIGINT and SIGTERM as a flag that runs look at between two steps; a second signal ends the program at once.
#pragma once

namespace ostium::app {

/// Thrown where there is nothing yet to save.
struct Interrupted {};

void catch_interrupts();
bool interrupted();

}  // namespace ostium::app
