// `ostium geometry SHAPE`: one subcommand per shape, its options made from the declared fields of the shape.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>

#include "app/commands.hpp"
#include "app/shape_fields.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::app {
namespace {

struct Arguments {
  std::map<std::string, std::string> values;  // of the fields, as written
  std::string output, unit = "mm";
};

std::string option_of(std::string field) {
  for (char& c : field)
    if (c == '_') c = '-';
  return "--" + field;
}

config::Node parameters_of(const Arguments& a) {
  config::Tree parameters = config::Tree::map();
  for (const auto& [name, value] : a.values)
    if (!value.empty()) parameters.add(name, config::Tree::scalar(value));
  return config::Node::parse(config::to_yaml(parameters), "command line");
}

/// A refused parameter is named by its option; a position in a command line helps nobody.
template <class Shape>
Shape shape_of(const Arguments& a) {
  try {
    return config::read<Shape>(parameters_of(a));
  } catch (const UserError& e) {
    const std::string text = e.what(), place = "command line:";
    user_error("{}", text.starts_with(place) ? text.substr(text.find(": ") + 2) : text);
  }
}

void write(const sph3d::Surface<3>& surface, const Arguments& a) {
  const double unit = config::read_unit(config::Node().with_text(a.unit), {.unit = "m"});
  sph3d::write_stl(surface, a.output, unit);
  fmt::print("{}\nwritten to {}, length_unit: {}\n",
             sph3d::describe(sph3d::read_lumen({.file = a.output, .length_unit = unit})), a.output, a.unit);
}

template <class Shape>
void add_shape(CLI::App& geometry, const char* name, const char* doc) {
  auto* command = geometry.add_subcommand(name, doc);
  auto a = std::make_shared<Arguments>();
  a->output = std::string(name) + ".stl";
  for (const auto& field : config::describe<Shape>())
    command
        ->add_option(option_of(field.name), a->values[field.name], field.doc + "; default " + field.fallback)
        ->type_name(field.unit.empty() ? "NUMBER" : "\"VALUE UNIT\"");
  command->add_option("-o,--output", a->output, "STL file")->capture_default_str();
  command->add_option("--length-unit", a->unit, "unit of the coordinates in the file")->capture_default_str();
  command->callback([a] { write(sph3d::generate(shape_of<Shape>(*a)), *a); });
}

}  // namespace

void add_geometry(CLI::App& program) {
  auto* command = program.add_subcommand("geometry", "make a closed vessel surface (STL) from a few numbers");
  command->require_subcommand(1);
  add_shape<sph3d::TubeShape>(*command, "tube", "straight tube, optionally tapered");
  add_shape<sph3d::BendShape>(*command, "bend", "straight, arc, straight");
  add_shape<sph3d::BifurcationShape>(*command, "bifurcation", "a parent that divides in two");
  add_shape<sph3d::ArchShape>(*command, "arch", "aortic arch with branches");
}

}  // namespace ostium::app
