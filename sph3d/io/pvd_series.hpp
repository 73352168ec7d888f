/// A ParaView collection (.pvd): which file shows which time, s.
///
/// Rewritten whole after each step, beside its name and then renamed, so that it is complete at any moment.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ostium::sph3d {

class PvdSeries {
 public:
  explicit PvdSeries(std::filesystem::path file);

  /// Takes over the entries of an existing file up to and including `time`; for runs that go on.
  void resume(double time);

  /// `data` is stored relative to the collection's folder.
  void add(double time, const std::filesystem::path& data);

  const std::filesystem::path& file() const { return file_; }
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    double time;
    std::string data;
  };
  void write() const;

  std::filesystem::path file_;
  std::vector<Entry> entries_;
};

}  // namespace ostium::sph3d
