#include "network/indices.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"

namespace ostium::network {

namespace {

using Kind = Index::Kind;

const std::map<std::string, Kind>& kinds() {
  static const std::map<std::string, Kind> all{{"mean", Kind::mean},
                                               {"max", Kind::max},
                                               {"min", Kind::min},
                                               {"pulse", Kind::pulse},
                                               {"ejection_fraction", Kind::ejection_fraction},
                                               {"stroke_volume", Kind::stroke_volume},
                                               {"flow_split", Kind::flow_split}};
  return all;
}

/// p:Ao_Pa -> Pa, m3, m3/s, m, m/s; x: without unit.
struct Unit {
  const char *suffix, *name;
};
constexpr Unit units[] = {{"_m3_s", "m3/s"}, {"_m_s", "m/s"}, {"_Pa", "Pa"}, {"_m3", "m3"}, {"_m", "m"}};

const Unit* unit_of(const std::string& series) {
  if (series.starts_with("x:")) return nullptr;
  for (const auto& u : units)
    if (series.ends_with(u.suffix)) return &u;
  return nullptr;
}

bool means(const std::string& series, const std::string& word) {
  const Unit* unit = unit_of(series);
  return series == word || (unit && series == word + unit->suffix);
}

int find_series(const std::string& word, const std::vector<std::string>& series, const std::string& where) {
  for (size_t i = 0; i < series.size(); ++i)
    if (means(series[i], word)) return static_cast<int>(i);
  user_error("{}: there is no series \"{}\"{}", where, word, did_you_mean(word, series));
}

void require(const std::string& series, std::initializer_list<const char*> quantities,
             const std::string& kind, const std::string& where) {
  for (const char* q : quantities)
    if (series.starts_with(q)) return;
  user_error("{}: {} is taken of a {}, and \"{}\" is none", where, kind,
             quantities.size() == 2        ? "volume (v:..) or a flow (q:..)"
             : **quantities.begin() == 'v' ? "volume (v:..)"
                                           : "flow (q:..)",
             series);
}

std::string unit_of_index(Kind kind, const std::string& series) {
  if (kind == Kind::ejection_fraction || kind == Kind::flow_split) return "1";
  if (kind == Kind::stroke_volume) return "m3";
  const Unit* unit = unit_of(series);
  return unit ? unit->name : "1";
}

}  // namespace

Index read_index(const std::string& text, const std::vector<std::string>& series, const std::string& where) {
  std::istringstream words(text);
  std::string kind, name, slash, whole, more;
  words >> kind >> name >> slash >> whole;
  if (!kinds().contains(kind)) {
    std::vector<std::string> all;
    for (const auto& [word, k] : kinds()) all.push_back(word);
    user_error("{}: there is no index \"{}\"{}", where, kind, did_you_mean(kind, all));
  }
  Index index{.text = text, .kind = kinds().at(kind)};
  const bool split = index.kind == Kind::flow_split;
  if (name.empty() || (split ? slash != "/" || whole.empty() : !slash.empty()) || words >> more)
    user_error("{}: \"{}\" is no index; write for example {}", where, text,
               split ? "\"flow_split q:left_m3_s / q:heart_m3_s\"" : "\"" + kind + " p:Ao_Pa\"");
  index.series = find_series(name, series, where);
  const std::string& found = series[index.series];
  if (split) index.of = find_series(whole, series, where), require(series[index.of], {"q:"}, kind, where);
  if (split) require(found, {"q:"}, kind, where);
  if (index.kind == Kind::ejection_fraction) require(found, {"v:"}, kind, where);
  if (index.kind == Kind::stroke_volume) require(found, {"v:", "q:"}, kind, where);
  index.unit = unit_of_index(index.kind, found);
  index.of_volume = found.starts_with("v:");
  return index;
}

}  // namespace ostium::network
