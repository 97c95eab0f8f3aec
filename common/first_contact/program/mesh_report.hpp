#pragma once
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/program/report.hpp"

namespace first_contact::program {

/// Tells what is wrong with a mesh that was loaded, a line each; nothing if nothing is.
/// \see diagnose
void tell_defects(Report& report, const Mesh& mesh);

}  // namespace first_contact::program
