/// Reading and writing of single values; each reader throws UserError saying what was found and what is
/// expected.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/config/info.hpp"
#include "core/config/node.hpp"
#include "core/csv.hpp"
#include "core/waveform.hpp"

namespace ostium::config {

double read_quantity(const Node&, const FieldInfo&);
double read_unit(const Node&, const FieldInfo&);  // "cm" or "2.5 cm": SI value of one such unit
double read_number(const Node&, const FieldInfo&);
long read_integer(const Node&, const FieldInfo&);
std::string read_text(const Node&, const FieldInfo&);
bool read_flag(const Node&, const FieldInfo&);
std::size_t read_choice(const Node&, const FieldInfo&);              // index into info.choices
std::filesystem::path read_path(const Node&, const FieldInfo&);      // relative to the document's folder
std::vector<double> read_quantities(const Node&, const FieldInfo&);  // [1 mm, 2 mm] or "1 2 mm"
std::vector<std::string> read_texts(const Node&, const FieldInfo&);

/// `{file: ..}`, `{times: .., values: ..}`, `{fourier: ..}` or a constant quantity: see waveform_yaml.cpp.
Waveform read_waveform(const Node&, const std::string& unit);
/// The same with the content of the file from elsewhere: of the file's name and the lines to skip.
using TableReader = std::function<Table(const std::filesystem::path&, int)>;
Waveform read_waveform(const Node&, const std::string& unit, const TableReader&);

Tree write_quantity(double, const std::string& unit);
Tree write_quantities(const std::vector<double>&, const std::string& unit);
Tree write_texts(const std::vector<std::string>&);
Tree write_path(const std::filesystem::path&);
Tree write_waveform(const Waveform&, const std::string& unit);

[[noreturn]] void missing_key(const Node& mapping, const FieldInfo&);
void require_mapping(const Node&, const Description&);

}  // namespace ostium::config
