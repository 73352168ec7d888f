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

ResultsFolder::ResultsFolder(fs::path folder, Earlier earlier)
    : folder_(std::move(folder)), earlier_(earlier) {
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    user_error("{}: the results need a folder, but this is a file; choose another one with -o",
               folder_.string());
  if (earlier_ == Earlier::resume) check_resumable();
  if (earlier_ == Earlier::refuse) check_free();
}

void ResultsFolder::check_free() const {
  if (is_finished(file("summary.json")))
    user_error(
        "{}: this folder holds the results of a finished run; choose another one with -o, or replace them "
        "with --force",
        folder_.string());
  if (fs::exists(checkpoint()))
    user_error(
        "{}: this folder holds a run that was not finished; go on with it with --resume, replace it with "
        "--force, or choose another folder with -o",
        folder_.string());
}

void ResultsFolder::check_resumable() const {
  if (fs::exists(checkpoint())) return;
  if (is_finished(file("summary.json")))
    user_error("{}: the run in this folder is finished, there is nothing to resume; replace it with --force",
               folder_.string());
  user_error(
      "{}: there is no checkpoint.h5 in this folder to resume from; name the folder of the interrupted run "
      "with -o, or start without --resume",
      folder_.string());
}

void ResultsFolder::create() const {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) user_error("{}: the results folder cannot be made: {}", folder_.string(), failed.message());
  if (resumes()) return;
  for (const char* name : {"case.effective.yaml", "ports.csv", "network.csv", "balance.csv", "wall.csv",
                           "probes.csv", "svzerod.csv", "sensitivities.csv", "sweep.csv", "sweep.h5",
                           "sobol.csv", "summary.json", "log.txt", "checkpoint.h5", "fields"})
    fs::remove_all(folder_ / name, failed);
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) user_error("{}: this file cannot be written; is the disk full?", file.string());
}

}  // namespace ostium::app
