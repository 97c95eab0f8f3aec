// says: make an Environment or a Bvh of the mesh, once
#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

bool hits(const Moving<Sphere>& ball, const Mesh& mesh) { return sweep(ball, mesh).has_value(); }
