#include "first_contact/program/mesh_report.hpp"

#include <string>

#include "first_contact/mesh_io/mesh_defects.hpp"

namespace first_contact::program {

//! [tell_defects]
void tell_defects(Report& report, const Mesh& mesh) {
  const MeshDefects defects = diagnose(mesh);
  if (defects.none()) return;
  report.say({"The mesh has faults; it is used as it is", "網格有瑕疵，仍照樣使用"});
  const auto row = [&](const std::string& what, std::size_t count, const Text& meaning) {
    if (count > 0) report.row(what, std::to_string(count), meaning);
  };
  row("degenerate triangles", defects.degenerate, {"without an area", "面積為零的三角形"});
  row("duplicate triangles", defects.duplicate, {"with the corners of another", "重複的三角形"});
  row("overfull edges", defects.non_manifold, {"of three triangles or more", "三個以上三角形共用的稜"});
}
//! [tell_defects]

}  // namespace first_contact::program
