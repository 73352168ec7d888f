#include <charconv>
#include <cstring>
#include <fstream>
#include <string_view>

#include "core/error.hpp"
#include "sph3d/geometry/soup.hpp"

namespace ostium::sph3d {
namespace {

constexpr std::size_t header_size = 80, prefix_size = 84, record_size = 50;

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  if (!in && !in.eof()) user_error("{}: cannot be read", file.string());
  return text;
}

std::size_t announced_triangles(const std::string& bytes) {
  std::uint32_t count;
  std::memcpy(&count, bytes.data() + header_size, sizeof count);
  return count;
}

/// A binary file may begin with "solid" too; only its size tells.
bool is_binary(const std::string& bytes) {
  if (bytes.size() >= prefix_size && bytes.size() == prefix_size + record_size * announced_triangles(bytes))
    return true;
  const auto word = bytes.find_first_not_of(" \t\r\n");
  const bool solid = word != bytes.npos && bytes.compare(word, 5, "solid") == 0;
  return !(solid && (bytes.find("facet") != bytes.npos || bytes.find("endsolid") != bytes.npos));
}

void check_finite(const Vec3& x, const std::filesystem::path& file, std::size_t triangle) {
  if (!x.allFinite())
    user_error("{}: the triangle {} has a corner that is not a finite point", file.string(), triangle);
}

Soup read_binary(const std::string& bytes, const std::filesystem::path& file) {
  if (bytes.size() < prefix_size)
    user_error(
        "{}: neither an ASCII STL (it does not begin with \"solid\") nor a binary one (it has {} bytes, the "
        "header alone needs {})",
        file.string(), bytes.size(), prefix_size);
  const std::size_t count = announced_triangles(bytes), needed = prefix_size + record_size * count;
  if (bytes.size() < needed)
    user_error(
        "{}: taken as a binary STL, its header announces {} triangles, which need {} bytes, but the file has "
        "{}; it is truncated or not an STL file",
        file.string(), count, needed, bytes.size());
  Soup soup;
  soup.points.reserve(3 * count), soup.facets.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    float corner[9];  // after the normal, which the corners imply
    std::memcpy(corner, bytes.data() + prefix_size + t * record_size + 12, sizeof corner);
    for (int k = 0; k < 3; ++k) {
      soup.points.emplace_back(corner[3 * k], corner[3 * k + 1], corner[3 * k + 2]);
      check_finite(soup.points.back(), file, t);
    }
    soup.facets.push_back({int(3 * t), int(3 * t + 1), int(3 * t + 2)});
  }
  return soup;
}

/// The words of an ASCII file, with the line each stands on.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  int line() const { return line_; }

  std::string_view next() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string_view rest_of_line() {
    const std::size_t begin = at_, end = std::min(text_.find('\n', at_), text_.size());
    at_ = end;
    auto rest = text_.substr(begin, end - begin);
    while (!rest.empty() && blank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && blank(rest.back())) rest.remove_suffix(1);
    return rest;
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  void skip_blanks() {
    for (; at_ < text_.size() && blank(text_[at_]); ++at_) line_ += text_[at_] == '\n';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

double number(Words& words, const std::filesystem::path& file) {
  const auto word = words.next();
  double value = 0;
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size())
    user_error("{}:{}: expected a coordinate, found \"{}\"{}", file.string(), words.line(), word,
               word.empty() ? " (the file ends here: it is truncated)" : "");
  return value;
}

/// Vertex lines between `facet` and `endfacet`; other words (normal, outer loop, ...) carry nothing we need.
void read_facet(Words& words, const std::filesystem::path& file, Soup& soup) {
  const int first = int(soup.points.size()), line = words.line();
  for (auto word = words.next(); word != "endfacet"; word = words.next()) {
    if (word.empty())
      user_error("{}:{}: the facet that begins here has no end; the file is truncated", file.string(), line);
    if (word != "vertex") continue;
    Vec3 x;
    for (double& c : x) c = number(words, file);
    check_finite(x, file, soup.facets.size());
    soup.points.push_back(x);
  }
  if (int(soup.points.size()) != first + 3)
    user_error("{}:{}: a facet has three vertices, this one has {}", file.string(), line,
               soup.points.size() - first);
  soup.facets.push_back({first, first + 1, first + 2});
}

Soup read_ascii(const std::string& text, const std::filesystem::path& file) {
  Soup soup;
  Words words(text);
  int solid = 0;
  bool ended = false;
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid") {
      soup.face_name[++solid] = words.rest_of_line();
      ended = false;
    } else if (word == "facet") {
      read_facet(words, file, soup);
      soup.face_id.push_back(solid);
    } else if (word == "endsolid") {
      words.rest_of_line();
      ended = true;
    }
  }
  if (!ended) user_error("{}: the ASCII STL has no closing \"endsolid\"; it is truncated", file.string());
  if (solid < 2) soup.face_id.clear(), soup.face_name.clear();  // one solid labels nothing
  return soup;
}

}  // namespace

Soup read_stl(const std::filesystem::path& file) {
  const std::string bytes = contents(file);
  if (bytes.empty()) user_error("{}: the file is empty", file.string());
  Soup soup = is_binary(bytes) ? read_binary(bytes, file) : read_ascii(bytes, file);
  if (soup.facets.empty()) user_error("{}: the STL file holds no triangle", file.string());
  return soup;
}

}  // namespace ostium::sph3d
