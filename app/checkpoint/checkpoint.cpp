#include "app/checkpoint/checkpoint.hpp"

#include <cstring>
#include <sstream>

#include "app/checkpoint/hdf5_archive.hpp"
#include "app/effective.hpp"
#include "app/version.hpp"
#include "core/error.hpp"
#include "core/log.hpp"

namespace ostium::app {
namespace {

/// The case without what may change while it runs.
Case essentials(Case study) {
  study.title.clear();
  study.time.end.reset();
  study.time.cycles.reset();
  study.output = {};
  study.numerics = {};
  study.coupling = {};
  if (!study.vessel) return study;
  study.vessel->surface.reset();
  study.vessel->outline.reset();
  return study;
}

/// FNV-1a over the bits of the corners.
template <int D>
std::uint64_t hash_of(const std::vector<Vec<D>>& corners) {
  std::uint64_t hash = 14695981039346656037u;
  for (const auto& corner : corners)
    for (int d = 0; d < D; ++d) {
      std::uint64_t bits;
      std::memcpy(&bits, &corner[d], sizeof bits);
      for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> 8 * byte & 0xff)) * 1099511628211u;
    }
  return hash;
}

/// The first line of a that stands elsewhere in b, and what stands there; empty where they are the same.
std::pair<std::string, std::string> first_difference(const std::string& a, const std::string& b) {
  std::istringstream lines_a(a), lines_b(b);
  const auto next = [](std::istringstream& lines) {
    std::string line;
    if (!std::getline(lines, line)) return std::string("nothing");
    const auto begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? line : line.substr(begin);
  };
  while (lines_a || lines_b) {
    const auto in_a = next(lines_a), in_b = next(lines_b);
    if (in_a != in_b) return {in_a, in_b};
  }
  return {};
}

void describe(Archive& a, CheckpointKey& key) {
  a("kind", key.kind);
  a("case", key.case_text);
  a("settings", key.settings);
}

void check_format(const std::filesystem::path& file, Archive& a) {
  std::int64_t format = 0;
  std::string program;
  a("format", format);
  if (format == checkpoint_format) return;
  a("program", program);
  user_error(
      "{}: this checkpoint has format {} (ostium {}), this program reads format {}; resume with the program "
      "that wrote it, or start the run anew without --resume",
      file.string(), format, program, checkpoint_format);
}

void check_key(const std::filesystem::path& file, const CheckpointKey& there, const CheckpointKey& here) {
  const auto [then, now] =
      first_difference(there.kind + "\n" + there.case_text, here.kind + "\n" + here.case_text);
  if (then != now)
    user_error(
        "{}: this checkpoint belongs to another case: it has `{}` where the case has `{}`; resume with the "
        "case it "
        "was made with, or start anew in another folder (-o) without --resume",
        file.string(), then, now);
  if (const auto [old_line, line] = first_difference(there.settings, here.settings); old_line != line)
    log::warn("the run goes on with other settings than it had: `{}` instead of `{}`", line, old_line);
}

}  // namespace

CheckpointKey checkpoint_key(const Case& study, const network::Model& model) {
  return {"network", effective_case(essentials(study), model), effective_case(study, model)};
}

template <int D>
CheckpointKey checkpoint_key(const Case& study, const network::Model& model, const sph3d::Lumen<D>& lumen) {
  CheckpointKey key = checkpoint_key(study, model);
  key.kind = fmt::format("vessel in {}D", D);
  key.case_text += fmt::format("geometry: {} corners, hash {:016x}\n", lumen.surface.points.size(),
                               hash_of<D>(lumen.surface.points));
  return key;
}

void write_checkpoint(const std::filesystem::path& file, CheckpointKey key, const ArchiveBody& body) {
  Hdf5Writer writer(file);
  std::int64_t format = checkpoint_format;
  std::string program = version;
  writer("format", format);
  writer("program", program);
  writer.part("key", [&] { describe(writer, key); });
  writer.part("body", [&] { body(writer); });
  writer.finish();
}

void read_checkpoint(const std::filesystem::path& file, const CheckpointKey& key, const ArchiveBody& body) {
  Hdf5Reader reader(file);
  check_format(file, reader);
  CheckpointKey saved;
  reader.part("key", [&] { describe(reader, saved); });
  check_key(file, saved, key);
  reader.part("body", [&] { body(reader); });
}

template CheckpointKey checkpoint_key(const Case&, const network::Model&, const sph3d::Lumen<2>&);
template CheckpointKey checkpoint_key(const Case&, const network::Model&, const sph3d::Lumen<3>&);

}  // namespace ostium::app
