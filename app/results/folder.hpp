/// The folder that takes the results of one run.
///
/// A folder with a finished run, or with one that can be resumed, is refused unless forced; what an earlier run left in it
/// is then removed, other files stay. A run that is resumed keeps everything, and there must be one. Nothing is created
/// before `create`, so that bad input leaves no trace.
#pragma once
#include <filesystem>
#include <string>

namespace ostium::app {

/// What to do with what an earlier run left.
enum class Earlier { refuse, replace, resume };

class ResultsFolder {
 public:
  /// Throws UserError when the folder holds what it must not hold, or cannot be a folder.
  ResultsFolder(std::filesystem::path folder, Earlier earlier);
  /// Makes the folder and removes what an earlier run left, unless that is resumed.
  void create() const;
  bool resumes() const { return earlier_ == Earlier::resume; }
  std::filesystem::path checkpoint() const { return file("checkpoint.h5"); }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& path() const { return folder_; }

 private:
  void check_free() const;
  void check_resumable() const;

  std::filesystem::path folder_;
  Earlier earlier_;
};

/// Writes a whole text file; throws UserError when that fails.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace ostium::app
