#include "core/text.hpp"

#include <algorithm>
#include <fstream>

#include "core/error.hpp"

namespace ostium {
namespace {

bool continues(std::string_view text, std::size_t i) {
  return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
}

/// Bytes of the character at i; 0 where none begins (Unicode 15, table 3-7).
std::size_t length_of_character(std::string_view text, std::size_t i) {
  const auto first = static_cast<unsigned char>(text[i]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF5   ? 0
                             : first >= 0xF0 ? 4
                             : first >= 0xE0 ? 3
                             : first >= 0xC2 ? 2
                                             : 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!continues(text, i + k)) return 0;
  if (length < 3) return length;
  const auto second = static_cast<unsigned char>(text[i + 1]);
  const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0, too_large = first == 0xF4 && second >= 0x90;
  return too_long || surrogate || too_large ? 0 : length;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
  constexpr std::uintmax_t most = 256u << 20;
  std::error_code failed;
  const auto status = std::filesystem::status(file, failed);
  if (status.type() == std::filesystem::file_type::not_found)
    user_error("{}: there is no such file; look at its name and its folder", file.string());
  if (std::filesystem::is_directory(status))
    user_error("{}: this is a folder; give the name of a file in it", file.string());
  if (!std::filesystem::is_regular_file(status))
    user_error("{}: this is no ordinary file but a device or a pipe; save its content to a file",
               file.string());
  std::ifstream stream(file, std::ios::binary);
  if (!stream) user_error("{}: this file cannot be read; look at its permissions", file.string());
  if (const auto size = std::filesystem::file_size(file, failed); !failed && size > most)
    user_error("{}: this file has {} MB, at most {} are read", file.string(), size >> 20, most >> 20);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t first_bad_byte(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    if (length == 0 || is_control(text[i])) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text, bool lines) {
  std::string made;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    if (length == 0 || is_control(text[i]) || text[i] == '\r')
      made += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    else if (text[i] == '\n' && !lines)
      made += "\\n";
    else
      made += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return made;
}

std::string shown(std::string_view text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return printable(text);
  std::size_t end = most;
  while (end > most - 4 && continues(text, end)) --end;
  return printable(text.substr(0, end)) + "...";
}

}  // namespace ostium
