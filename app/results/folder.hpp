/// The folder that takes the results of one run.
///
/// A folder whose summary.json says `finished` is refused unless forced; what an earlier run left in it is
/// then removed, other files stay. Nothing is created before `create`, so that bad input leaves no trace.
#pragma once
#include <filesystem>
#include <string>

namespace ostium::app {

class ResultsFolder {
 public:
  /// Throws UserError when the folder holds a finished run (and `force` is not given) or cannot be a folder.
  ResultsFolder(std::filesystem::path folder, bool force);
  /// Makes the folder and removes what an earlier run left.
  void create() const;
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Writes a whole text file; throws UserError when that fails.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace ostium::app
