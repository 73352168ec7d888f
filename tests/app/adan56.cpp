// The ADAN56 network (Boileau et al. 2015) from openBF's file against the means that another encoding of it, STARFiSh's, implies:
// Poiseuille's resistance of every cone, Windkessels at the ends, a tree of resistances.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <sstream>

#include "program.hpp"

namespace ostium::test {
namespace {

struct Segment {
  std::string name;
  double resistance = 0, outlet = 0;  // Pa.s/m3
  std::vector<int> daughters = {};
};

/// Between <key ..> and the next tag; NaN where there is none.
double number(const std::string& part, const std::string& key) {
  std::smatch found;
  const std::regex pattern("<" + key + "[^>]*>([0-9][^<]*)<");
  return std::regex_search(part, found, pattern) ? std::stod(found[1]) : std::nan("");
}

/// Calls f(id, text) for every element of this name and attribute.
template <class F>
void for_elements(const std::string& xml, const std::string& name, const std::string& attribute, F&& f) {
  const std::string open = "<" + name + " " + attribute + "=\"";
  for (std::size_t at = xml.find(open); at != std::string::npos; at = xml.find(open, at + 1))
    f(std::stoi(xml.substr(at + open.size())), xml.substr(at, xml.find("</" + name + ">", at) - at));
}

std::map<int, Segment> read_starfish(const std::string& xml) {
  std::map<int, Segment> tree;
  for_elements(xml, "vessel", "Id", [&](int id, const std::string& text) {
    const double a = number(text, "radiusProximal"), b = number(text, "radiusDistal");
    Segment& s = tree[id];
    const std::size_t name = text.find("name=\"") + 6;
    s.name = text.substr(name, text.find('"', name) - name);
    s.resistance = 8 * 4e-3 / std::numbers::pi * number(text, "length") * (a * a + a * b + b * b) /
                   (3 * std::pow(a * b, 3));
    for (const char* side : {"leftDaughter", "rightDaughter"})
      if (const double daughter = number(text, side); !std::isnan(daughter))
        s.daughters.push_back(static_cast<int>(daughter));
  });
  for_elements(xml, "boundaryCondition", "vesselId", [&](int id, const std::string& text) {
    if (text.find("Windkessel") != std::string::npos)
      tree.at(id).outlet = number(text, "Rc") + number(text, "Z");
  });
  return tree;
}

double resistance(const std::map<int, Segment>& tree, int id) {
  const Segment& s = tree.at(id);
  if (s.daughters.empty()) return s.resistance + s.outlet;
  double conductance = 0;
  for (const int d : s.daughters) conductance += 1 / resistance(tree, d);
  return s.resistance + 1 / conductance;
}

/// Mean flow of each last segment, m3/s, of `flow` into segment `id`.
void share_out(const std::map<int, Segment>& tree, int id, double flow, std::map<std::string, double>& ends) {
  const Segment& s = tree.at(id);
  if (s.daughters.empty()) ends[s.name] = flow;
  const double beyond = resistance(tree, id) - s.resistance;
  for (const int d : s.daughters) share_out(tree, d, flow * beyond / resistance(tree, d), ends);
}

double mean_inflow(std::istringstream rows) {
  double t = 0, q = 0, sum = 0;
  std::string row;
  std::getline(rows, row);  // names
  while (std::getline(rows, row)) {
    double time, flow;
    char separator;
    if (!(std::istringstream(row) >> time >> separator >> flow)) continue;
    sum += (time - t) * (flow + q) / 2, t = time, q = flow;
  }
  return sum / t;
}

class Adan56 : public ProgramTest {};

TEST_F(Adan56, MeanPressureAndFlowsAreThoseOfTheOtherEncoding) {
  const auto data = std::filesystem::path(OSTIUM_DATA_DIR) / "networks";
  const auto model = data / "openbf_boileau2015/adan56/adan56.yaml";
  const std::string other = (data / "starfish_adan56/adan56_benchmark2015_").string();
  if (!std::filesystem::exists(model) || !std::filesystem::exists(other + "template.xml"))
    GTEST_SKIP() << "needs the reference data (networks)";
  ASSERT_EQ(ostium("import openbf " + model.string() + " -o adan56.yaml").code, 0);
  ASSERT_EQ(ostium("run adan56.yaml").code, 0);
  const auto series = nlohmann::json::parse(content("results/adan56/summary.json"))["series"];
  const auto tree = read_starfish(content(other + "template.xml"));
  ASSERT_EQ(tree.size(), 77u);
  const double flow = mean_inflow(std::istringstream(content(other + "inflow_template.csv"))),
               pressure = flow * resistance(tree, 1);
  EXPECT_NEAR(series["q:inlet_m3_s"]["mean"].get<double>(), flow, 0.01 * flow);
  EXPECT_NEAR(series["p:n1_Pa"]["mean"].get<double>(), pressure, 0.03 * pressure);
  std::map<std::string, double> ends;
  share_out(tree, 1, flow, ends);
  EXPECT_EQ(ends.size(), 31u);
  for (const auto& [name, expected] : ends) {
    const std::string key = "q:" + name + ".outlet_m3_s";
    ASSERT_TRUE(series.contains(key)) << key;
    EXPECT_NEAR(series[key]["mean"].get<double>(), expected, 0.03 * expected) << name;
  }
}

}  // namespace
}  // namespace ostium::test
