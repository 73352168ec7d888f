#include "app/results/folder.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace ostium::app {

namespace fs = std::filesystem;

namespace {

bool is_finished(const fs::path& summary) {
  std::ifstream stream(summary);
  const auto content = nlohmann::json::parse(stream, nullptr, false);
  return content.is_object() && content.value("status", "") == "finished";
}

}  // namespace

ResultsFolder::ResultsFolder(fs::path folder, bool force) : folder_(std::move(folder)) {
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    user_error("{}: the results need a folder, but this is a file; choose another one with -o",
               folder_.string());
  if (!force && is_finished(folder_ / "summary.json"))
    user_error(
        "{}: this folder holds the results of a finished run; choose another one with -o, or replace them "
        "with --force",
        folder_.string());
}

void ResultsFolder::create() const {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) user_error("{}: the results folder cannot be made: {}", folder_.string(), failed.message());
  for (const char* name : {"case.effective.yaml", "ports.csv", "network.csv", "balance.csv", "summary.json",
                           "log.txt", "checkpoint.bin", "fields"})
    fs::remove_all(folder_ / name, failed);
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) user_error("{}: this file cannot be written; is the disk full?", file.string());
}

}  // namespace ostium::app
