#include "sph3d/geometry/choose.hpp"

#include <algorithm>
#include <charconv>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "sph3d/geometry/repair.hpp"

namespace ostium::sph3d {
namespace {

int by_rank(const std::vector<Opening<3>>& openings, const OpeningChoice& choice) {
  const int rank = *choice.largest, n = int(openings.size());
  if (rank < 1 || rank > n)
    user_error(
        "{}opening '{}': the vessel has {} opening{}, so `largest` lies between 1 and {}; found {}\n{}",
        choice.where, choice.name, n, n == 1 ? "" : "s", n, rank, table(openings));
  return rank - 1;
}

int by_place(const std::vector<Opening<3>>& openings, const Vec3& x) {
  const auto nearer = [&](const auto& a, const auto& b) {
    return (a.centre - x).norm() < (b.centre - x).norm();
  };
  return int(std::min_element(openings.begin(), openings.end(), nearer) - openings.begin());
}

bool carries(const Opening<3>& opening, const std::string& label) {
  return (!opening.face_name.empty() && opening.face_name == label) ||
         (opening.face_id >= 0 && std::to_string(opening.face_id) == label);
}

std::vector<std::string> labels(const std::vector<Opening<3>>& openings) {
  std::vector<std::string> all;
  for (const auto& o : openings) {
    if (!o.face_name.empty()) all.push_back(o.face_name);
    if (o.face_id >= 0) all.push_back(std::to_string(o.face_id));
  }
  return all;
}

int by_label(const std::vector<Opening<3>>& openings, const OpeningChoice& choice) {
  const auto has = [&](const Opening<3>& o) { return carries(o, *choice.label); };
  const auto found = std::find_if(openings.begin(), openings.end(), has);
  if (found == openings.end()) {
    const auto known = labels(openings);
    const auto hint = known.empty()
                          ? std::string("; this surface carries no labels: choose by `largest` or `nearest`")
                          : did_you_mean(*choice.label, known);
    user_error("{}opening '{}': no opening has the label {}{}\n{}", choice.where, choice.name, *choice.label,
               hint, table(openings));
  }
  if (std::count_if(openings.begin(), openings.end(), has) > 1)
    user_error("{}opening '{}': several openings have the label {}; choose by `nearest`\n{}", choice.where,
               choice.name, *choice.label, table(openings));
  return int(found - openings.begin());
}

int chosen(const std::vector<Opening<3>>& openings, const OpeningChoice& choice) {
  if (choice.largest.has_value() + choice.nearest.has_value() + choice.label.has_value() != 1)
    user_error("{}opening '{}': say which opening it is by exactly one of `largest`, `nearest`, `label`",
               choice.where, choice.name);
  if (choice.largest) return by_rank(openings, choice);
  return choice.label ? by_label(openings, choice) : by_place(openings, *choice.nearest);
}

/// Whether the choice would fall on this end if it were plane. Ranks cannot tell: they count the openings only.
bool means(const OpeningChoice& choice, const std::vector<Opening<3>>& openings, const UnevenEnd& end) {
  if (choice.largest) return *choice.largest == int(openings.size()) + 1;
  if (choice.label)
    return !end.label.empty() && (*choice.label == end.label || *choice.label == end.face_name);
  if (!choice.nearest) return false;
  const double away = (*choice.nearest - end.centre).norm();
  return std::all_of(openings.begin(), openings.end(),
                     [&](const auto& o) { return away < (o.centre - *choice.nearest).norm(); });
}

}  // namespace

void name_openings(std::vector<Opening<3>>& openings, const std::vector<OpeningChoice>& choices,
                   const std::vector<UnevenEnd>& uneven) {
  std::vector<const OpeningChoice*> owner(openings.size(), nullptr);
  for (const auto& choice : choices) {
    for (const auto& end : uneven)
      if (means(choice, openings, end))
        refuse(end, fmt::format("{}opening '{}': ", choice.where, choice.name));
    const int k = chosen(openings, choice);
    if (owner[k])
      user_error("{}the names '{}' and '{}' fall on the same opening, at {}; give each its own\n{}",
                 choice.where, owner[k]->name, choice.name, place(openings[k].centre), table(openings));
    owner[k] = &choice;
  }
  for (std::size_t k = 0; k < openings.size(); ++k)
    if (owner[k]) openings[k].name = owner[k]->name;
}

std::string table(const std::vector<Opening<3>>& openings) {
  std::string text = fmt::format("  {:>4}  {:<14} {:>12}{:>11}  {:<34}  {:<24}  {}\n", "rank", "name",
                                 "area mm2", "diameter", "centre", "outward normal", "label");
  for (std::size_t k = 0; k < openings.size(); ++k) {
    const auto& o = openings[k];
    const auto label = o.face_id < 0 ? std::string("-") : std::to_string(o.face_id) + " " + o.face_name;
    text +=
        fmt::format("  {:>4}  {:<14} {:>12.4g}{:>11}  {:<34}  {:<24}  {}\n", k + 1, o.name, 1e6 * o.area,
                    size(std::sqrt(4 * o.area / pi)), place(o.centre),
                    fmt::format("({:.3f}, {:.3f}, {:.3f})", o.normal.x(), o.normal.y(), o.normal.z()), label);
  }
  return text;
}

}  // namespace ostium::sph3d
