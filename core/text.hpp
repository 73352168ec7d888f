/// Texts of users: read whole from a file, and shown in a message as one line that a terminal can print.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace ostium {

/// The content of a regular file of at most 256 MB: a device or a pipe might never end. Throws UserError.
std::string read_text_file(const std::filesystem::path& file);

/// Where the first byte stands that belongs to no text: a control character other than tabulator and line end, or one
/// that is no UTF-8; npos if there is none.
std::size_t first_bad_byte(std::string_view text);

/// Such bytes as \x04, and line ends as \n unless `lines` may stand.
std::string printable(std::string_view text, bool lines = false);

/// What a message quotes of a value: printable, and no more than its beginning.
std::string shown(std::string_view text);

}  // namespace ostium
