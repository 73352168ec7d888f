#include "core/did_you_mean.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/text.hpp"

namespace ostium {
namespace {

std::string lower(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
  return s;
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t n = a.size(), m = b.size();
  std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
  for (std::size_t i = 0; i <= n; ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= m; ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t j = 1; j <= m; ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 200;  // the comparison takes memory for the product of both lengths
  if (word.size() > longest) return {};
  std::optional<std::string> nearest;
  int least = 1 + static_cast<int>(word.size() + 2) / 3;
  for (const auto& candidate : candidates) {
    const auto longer = std::max(candidate.size(), word.size()) - std::min(candidate.size(), word.size());
    if (candidate.size() > longest || static_cast<int>(longer) >= least) continue;  // at least so many edits
    const int d = edit_distance(lower(word), lower(candidate));
    if (d < least && d < static_cast<int>(std::max(word.size(), candidate.size())))
      least = d, nearest = candidate;
  }
  return nearest;
}

namespace {

/// The beginning of a long list: a network may have thousands of names.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 60;
  std::vector<std::string> some(names.begin(), names.begin() + std::min(names.size(), most));
  for (auto& name : some) name = shown(name);
  const auto left = names.size() - some.size();
  return fmt::format("{}{}", fmt::join(some, ", "), left ? fmt::format(" and {} more", left) : "");
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto nearest = nearest_name(word, candidates);
  const std::string question = nearest ? fmt::format("did you mean \"{}\"? ", *nearest) : "";
  return candidates.empty() ? "" : fmt::format("; {}Allowed: {}", question, listed(candidates));
}

}  // namespace ostium
