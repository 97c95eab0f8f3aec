#include "plain_length.hpp"

using namespace first_contact;

namespace tween_bounce {

//! [plain_length]
double plain_length(const Curve& curve, int chords) {
  double length = 0;
  Point here = at(curve, 0);
  for (int i = 1; i <= chords; ++i) {
    const Point next = at(curve, static_cast<double>(i) / chords);
    length += norm(Vector(next - here));
    here = next;
  }
  return length;
}
//! [plain_length]

}  // namespace tween_bounce
