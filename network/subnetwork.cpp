// What a definition of a subnetwork must be.
#include "network/subnetwork.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "network/shipped.hpp"

namespace ostium::network {
namespace {

std::string check_parameter(const SubnetworkParameter& p) {
  if (p.unit == "1" || !p.value) return {};
  if (p.value->find('$') != std::string::npos)
    return "the default \"" + *p.value + "\" must be a plain value; parameters stand in the blocks only";
  return {};
}

bool is_name(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

std::string bad_name(const char* kind, const std::string& name) {
  return is_name(name)
             ? ""
             : fmt::format("the {} \"{}\" cannot be named so; letters, digits and _ are allowed", kind, name);
}

std::string check_names(const Subnetwork& s) {
  const auto ports = s.port_names();
  for (const auto& port : ports)
    if (auto bad = bad_name("port", port); !bad.empty()) return bad;
  for (const auto& [name, p] : s.parameters) {
    if (auto bad = bad_name("parameter", name); !bad.empty()) return bad;
    if (name == "type" || std::find(ports.begin(), ports.end(), name) != ports.end())
      return "\"" + name + "\" is both a parameter and a port or a key of every block; rename the parameter";
  }
  return {};
}

std::string check_subnetwork(const Subnetwork& s) {
  if (!s.blocks.is_map() || s.blocks.entries().empty())
    return "a subnetwork needs blocks; write for example `blocks: {r: {type: resistor, from: in, to: out, R: "
           "1e8 Pa.s/m3}}`";
  for (const auto& key : s.blocks.keys())
    if (auto bad = bad_name("block", key); !bad.empty()) return bad;
  return check_names(s);
}

}  // namespace

std::vector<std::string> Subnetwork::port_names() const {
  if (ports.is_null()) return {};
  if (ports.is_map()) return ports.keys();
  std::vector<std::string> names;
  for (const auto& item : ports.items()) names.push_back(item.text());
  return names;
}

std::string Subnetwork::port_doc(const std::string& port) const {
  if (!ports.is_map()) return {};
  const auto meaning = ports.find(port);
  return meaning && meaning->is_scalar() ? meaning->text() : "";
}

void declare(config::Fields<SubnetworkParameter>& f) {
  f.text("unit", &SubnetworkParameter::unit, "unit of its dimension, such as Pa.s/m3; 1 for a number")
      .or_else("1");
  f.text("default", &SubnetworkParameter::value, "value where a use gives none; without it every use must");
  f.text("doc", &SubnetworkParameter::doc, "meaning").or_else("");
  f.origin(&SubnetworkParameter::origin);
  f.check(check_parameter);
}

void declare(config::Fields<Subnetwork>& f) {
  f.text("doc", &Subnetwork::doc, "what it is, one sentence").or_else("");
  f.text("source", &Subnetwork::source, "where model and values come from").or_else("");
  f.raw("ports", &Subnetwork::ports,
        "nodes inside that a use joins to nodes outside: `[in, out]` or `{in: meaning, ..}`")
      .or_else({});
  f.map("parameters", &Subnetwork::parameters, "values that a use may give").or_else({});
  f.raw("blocks", &Subnetwork::blocks, "its blocks by name, like `network.blocks`; `$NAME` is a parameter");
  f.origin(&Subnetwork::origin);
  f.check(check_subnetwork);
}

const Subnetworks& shipped_subnetworks() {
  static const Subnetworks all = [] {
    Subnetworks made;
    for (const auto& [file, text] : shipped_texts())
      for (const auto& [name, node] : config::Node::parse(text, std::string("ostium/") + file).entries())
        made.emplace_back(name, config::read<Subnetwork>(node));
    return made;
  }();
  return all;
}

}  // namespace ostium::network
