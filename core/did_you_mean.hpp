/// The nearest valid name for a misspelt one, by edit distance (insert, delete, replace, swap of neighbours).
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace ostium {

/// Least number of edits from a to b; neighbouring swapped letters count as one.
int edit_distance(const std::string& a, const std::string& b);

/// The candidate nearest to `word`, letter case aside; none if all differ by more than about a third of their
/// letters.
std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// The tail of an error sentence: `; did you mean "Rp"? Allowed: Rp, C, Rd` or without the question when
/// nothing is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace ostium
