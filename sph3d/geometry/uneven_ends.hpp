/// Parts of a closed surface that look like its ends but are not plane: no openings, and rarely meant as wall. Internal to
/// geometry/.
///
///   rim     sharp all around, bent back into the vessel, and no opening beyond it
///   shape   seen along its normal it covers half of its own area or more, and leaves its plane by less than its size, where
///           it has no label by less than a quarter of it
///
/// Labelled faces are looked at first, without any the parts that lie between sharp edges. A surface that names
/// such a part as an opening is refused; where nobody does, it is wall, and said to be.
#pragma once
#include "sph3d/geometry/find_openings.hpp"

namespace ostium::sph3d {

struct UnevenEnd {
  Vec3 centre;
  std::string label, face_name;  ///< empty where the file has none
  std::string text;  ///< "the face 3 of t.vtp at (0, 0, 40) mm, 10 mm across, is not plane: it leaves ..."
};

/// Sorted by falling area; `surface` has its openings labelled. `file`: for the text.
std::vector<UnevenEnd> uneven_ends(const Surface<3>& surface, const Soup& soup, const std::string& file);

/// Throws UserError: the text, after `where`, and how to mend it.
[[noreturn]] void refuse(const UnevenEnd& end, const std::string& where = {});

}  // namespace ostium::sph3d
