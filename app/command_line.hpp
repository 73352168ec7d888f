/// The commands of the program and its exit codes.
///
///   0 done   2 user error   3 numerics error   70 bug   130 interrupted
#pragma once

namespace ostium::app {

int run_program(int argc, char** argv);

}  // namespace ostium::app
