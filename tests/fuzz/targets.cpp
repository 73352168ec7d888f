#include "targets.hpp"

namespace ostium::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"case", read_case_text},
                                       {"svzerod", read_svzerod_text},
                                       {"openbf", read_openbf_text},
                                       {"table", read_table_text}};
  return all;
}

}  // namespace ostium::fuzz
