/// checkpoint.h5: everything a run goes on from, with what tells whether it belongs to the case.
///
///   format      of this file; another one is refused
///   case        the effective case without what may change on the way: title, end of the run, output, numerics, coupling,
///               names of files; the geometry by a hash of its corners. Another one is refused.
///   settings    the whole effective case; what differs is warned of
///   body        the state itself, as the run describes it (core/archive)
///
/// Source: docs/decisions/0012-checkpoints.md. Not checked: that the same program on the same machine goes on; another
/// compiler or processor gives other last bits.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "app/case.hpp"
#include "core/archive.hpp"
#include "network/model.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::app {

inline constexpr std::int64_t checkpoint_format = 4;

struct CheckpointKey {
  std::string kind;       // "vessel in 3D", "network"
  std::string case_text;  // must be the same
  std::string settings;   // should be the same
};

CheckpointKey checkpoint_key(const Case& study, const network::Model& model);
template <int D>
CheckpointKey checkpoint_key(const Case& study, const network::Model& model, const sph3d::Lumen<D>& lumen);

using ArchiveBody = std::function<void(Archive&)>;

void write_checkpoint(const std::filesystem::path& file, CheckpointKey key, const ArchiveBody& body);

/// Throws UserError when the file is damaged, of another format or of another case.
void read_checkpoint(const std::filesystem::path& file, const CheckpointKey& key, const ArchiveBody& body);

}  // namespace ostium::app
