/// The JSON schema of the case file and the reference pages, both made from the declared fields.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ostium::app {

/// JSON schema of the whole case, with the blocks of the network.
std::string case_schema();

/// Writes case.md, blocks.md and waveform.md; returns the files.
std::vector<std::filesystem::path> write_reference(const std::filesystem::path& folder);

}  // namespace ostium::app
