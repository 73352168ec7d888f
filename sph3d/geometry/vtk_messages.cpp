#include "sph3d/geometry/vtk_messages.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace ostium::sph3d {
namespace {

class Listener : public vtkOutputWindow {
 public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);
  void DisplayText(const char* text) override {
    if (first.empty() && text && GetCurrentMessageType() == MESSAGE_TYPE_ERROR) first = text;
  }
  std::string first;
};
vtkStandardNewMacro(Listener);

}  // namespace

VtkMessages::VtkMessages() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkSmartPointer<Listener>::New());
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(nullptr); }

std::string VtkMessages::first_error() const {
  const auto* listener = Listener::SafeDownCast(vtkOutputWindow::GetInstance());
  std::string text = listener ? listener->first : "";
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  // "ERROR: In file, line n\nvtkClass (0x...): what is wrong"
  if (const auto from = text.find("): "); from != text.npos) text = text.substr(from + 3);
  return text.substr(0, text.find('\n'));
}

}  // namespace ostium::sph3d
