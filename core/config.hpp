/// Configuration: each field of a struct is declared once; reader, checks, schema, reference and write-back
/// follow.
///
///   struct Windkessel { double Rp, C, Rd, Pd; };
///   inline void declare(config::Fields<Windkessel>& f) {                       // found by
///   argument-dependent lookup
///     f.quantity("Rp", &Windkessel::Rp, "Pa.s/m3", "proximal resistance").positive();
///     f.quantity("Pd", &Windkessel::Pd, "Pa", "distal pressure").or_else(0.0);  // a default makes it
///     optional
///   }
///   auto w = config::read<Windkessel>(config::Node::load("case.yaml").at("dao"));
///
/// Reading throws UserError with file:line:column and the path of the key for: unknown keys (with the nearest
/// valid name), missing keys, missing or unknown units, wrong dimensions, values out of range, numbers that
/// are not finite, wrong kinds of node, keys given twice. `config::schema<S>()` is in core/config/schema.hpp.
#pragma once
#include "core/config/fields.hpp"
#include "core/config/info.hpp"
#include "core/config/node.hpp"
#include "core/config/tree.hpp"

namespace ostium::config {

/// The declared fields of S.
template <class S>
const Fields<S>& fields() {
  static const Fields<S> list = [] {
    Fields<S> f;
    declare(f);
    return f;
  }();
  return list;
}

/// What is known of S's fields as plain data.
template <class S>
Description describe() {
  return fields<S>().description();
}

/// S from a mapping; `also_allowed` names keys that somebody else reads from the same mapping.
template <class S>
S read(const Node& node, const std::vector<std::string>& also_allowed = {}) {
  return fields<S>().read(node, also_allowed);
}

/// S as a tree in SI units with every default filled in.
template <class S>
Tree write(const S& s) {
  return fields<S>().write(s);
}

/// S as YAML text in SI units; reads back to the same S.
template <class S>
std::string emit(const S& s) {
  return to_yaml(write(s));
}

/// Markdown table of S's fields: name, unit, range, default, meaning; nested structs in tables below it.
template <class S>
std::string reference(const std::string& title = {}) {
  return reference_of(describe<S>(), title);
}

}  // namespace ostium::config
