#include "lumped/two_terminal.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

namespace ostium::lumped {

namespace {

std::vector<Terminal> ends(const TwoTerminal& b, double ground) {
  return {{"from", b.from.value_or(""), ground}, {"to", b.to.value_or(""), ground}};
}

constexpr std::size_t longest_name = 200;

void check_nodes(const TwoTerminal& b) {
  if (!b.from && !b.to) user_error("names no node; give `from: NODE` or `to: NODE`, or both");
  if ((b.from && b.from->empty()) || (b.to && b.to->empty()))
    user_error("has a node without a name; write for example `{}: DAo`",
               b.from && b.from->empty() ? "from" : "to");
  for (const auto& node : {b.from, b.to})
    if (node && (node->size() > longest_name || node->find('\n') != std::string::npos))
      user_error("has the node \"{}\"; a name is one line of at most {} characters", shown(*node),
                 longest_name);
  if (b.from && b.to && *b.from == *b.to)
    user_error("begins and ends at the same node \"{}\"; a block joins two different nodes", *b.from);
}

void refuse_third_end(const TwoTerminal& b, const std::optional<double>& pressure, const char* key) {
  if (b.from && b.to && pressure)
    user_error("has `from`, `to` and `{}`; a block has two ends, so drop one of the three", key);
}

}  // namespace

std::vector<Terminal> two_ends(const TwoTerminal& b, std::optional<double> ground) {
  check_nodes(b);
  refuse_third_end(b, ground, "ground");
  if ((!b.from || !b.to) && !ground)
    user_error(
        "ends at one node only (`{}: {}`); name the other one with `{}`, or end it at a fixed pressure, for "
        "example "
        "`ground: 0 mmHg`",
        b.from ? "from" : "to", b.from ? *b.from : *b.to, b.from ? "to" : "from");
  return ends(b, ground.value_or(0));
}

std::vector<Terminal> grounded_ends(const TwoTerminal& b, std::optional<double> ground) {
  check_nodes(b);
  refuse_third_end(b, ground, "ground");
  return ends(b, ground.value_or(0));
}

std::vector<Terminal> distal_end(const TwoTerminal& b, std::optional<double> Pd) {
  check_nodes(b);
  if (!b.from) user_error("has no `from`; name the node its flow comes from");
  refuse_third_end(b, Pd, "Pd");
  return ends(b, Pd.value_or(0));
}

std::vector<Terminal> source_ends(const TwoTerminal& b) {
  check_nodes(b);
  return ends(b, 0);
}

}  // namespace ostium::lumped
