/// What reads files of users, as functions of the content of such a file.
///
///   case       YAML of a case: reading, the network with consistent start values, what the run would write as
///              case.effective.yaml and reading that again
///   svzerod    JSON of svZeroDSolver -> case -> network; where it holds observations also the calibration's reading
///   openbf     YAML of openBF -> case -> network
///   table      CSV of a waveform, in the forms in which a case may ask for it
///
/// A target returns for every text, accepted or refused. It throws where the program would have a bug: an error that is
/// neither UserError nor NumericsError, or a refusal that is not one line naming its file.
#pragma once
#include <string_view>
#include <vector>

namespace ostium::fuzz {

struct Target {
  const char* name;
  void (*run)(std::string_view content);
};

void read_case_text(std::string_view content);
void read_svzerod_text(std::string_view content);
void read_openbf_text(std::string_view content);
void read_table_text(std::string_view content);

const std::vector<Target>& targets();

}  // namespace ostium::fuzz
