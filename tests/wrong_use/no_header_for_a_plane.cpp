// says: include first_contact/sweep/sphere_plane.hpp
#include "first_contact/geometry/plane.hpp"
#include "first_contact/sweep/obstacle.hpp"

using namespace first_contact;

bool hits(const Moving<Sphere>& ball, const Plane& plane) { return sweep(ball, plane).has_value(); }
