/// What an importer made must pass the program's own checks, lest the user meets their errors in a file nobody wrote.
#pragma once
#include <filesystem>
#include <string>

namespace ostium::app {

/// Throws UserError that names the model's file where the case is refused.
void check_imported(const std::string& yaml, const std::filesystem::path& model);

}  // namespace ostium::app
