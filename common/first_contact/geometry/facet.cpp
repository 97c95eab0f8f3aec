#include "first_contact/geometry/facet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace first_contact {

Facet::Facet(const Triangle& t)
    : triangle(t), corner(t.a), normal(Vector::Zero()), length(0), longest(0), largest_radius(0) {
  const Vector ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
  const double l_ab = ab.squaredNorm(), l_bc = bc.squaredNorm(), l_ca = ca.squaredNorm();
  const double l_max = std::max({l_ab, l_bc, l_ca});
  if (l_bc == l_max) {
    corner = t.a;
    normal = ca.cross(ab);
  } else if (l_ca == l_max) {
    corner = t.b;
    normal = ab.cross(bc);
  } else {
    corner = t.c;
    normal = bc.cross(ca);
  }
  length = normal.norm();
  longest = std::sqrt(l_max);
  // Let l be the longest side and h the height above it. A ball of radius r that lies on the edges on both
  // sides of the triangle sags through its face by at most h^2 / 2r. The rounded normal, in turn, may be
  // tilted by eps l / h, which costs r (eps l / h)^2 / 2. Where h^2 = 2 eps l r, the first is eps l and the
  // second eps l / 4: with the edges for thinner triangles and the face for thicker ones, no triangle errs by
  // more than eps l.
  if (length > 0)
    largest_radius =
        length * length / (2 * std::numeric_limits<double>::epsilon() * longest * longest * longest);
}

}  // namespace first_contact
