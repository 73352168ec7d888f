/// Archives in an HDF5 file: every array a data set with a checksum, every part a group.
///
/// The file is written under another name and renamed by `finish`, so that what stands under its name is always whole.
/// Reading throws UserError where the file is damaged, cut short or of another kind. Not checked: the meaning of the
/// numbers.
#pragma once
#include <filesystem>
#include <memory>

#include "core/archive.hpp"

namespace ostium::app {

class Hdf5Archive : public Archive {
 public:
  ~Hdf5Archive() override;
  [[noreturn]] void misfit(const std::string& name, const std::string& problem) const override;

 protected:
  explicit Hdf5Archive(std::filesystem::path path);
  void enter(const std::string& name) override { prefix_ += name + "/"; }
  void leave() override { prefix_.erase(prefix_.rfind('/', prefix_.size() - 2) + 1); }

  struct File;  // of the HDF5 library
  std::filesystem::path path_;
  std::string prefix_ = "/";
  std::unique_ptr<File> file_;
};

class Hdf5Writer final : public Hdf5Archive {
 public:
  explicit Hdf5Writer(std::filesystem::path path);
  ~Hdf5Writer() override;  // what was not finished is removed
  bool reading() const override { return false; }
  /// Puts the file in place; throws UserError when it could not be written whole.
  void finish();

 private:
  void array(const std::string& name, Kind kind, std::size_t records, std::size_t per_record,
             const Place& place) override;
  [[noreturn]] void give_up() const;

  std::filesystem::path beside_;
};

class Hdf5Reader final : public Hdf5Archive {
 public:
  explicit Hdf5Reader(std::filesystem::path path);
  bool reading() const override { return true; }

 private:
  void array(const std::string& name, Kind kind, std::size_t records, std::size_t per_record,
             const Place& place) override;
};

}  // namespace ostium::app
