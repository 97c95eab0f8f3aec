#pragma once
#include "entry.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/easing.hpp"
#include "first_contact/motion/path.hpp"

namespace tween_bounce {

/// The easing of an entry: a name, such as "in-out cubic" or a style sheet's "ease-out", or an object with one of
/// "cubic-bezier", "steps", "spring" and "power".
/// \throws FilmError that names the place.
first_contact::Easing easing_of(const Entry& entry);

/// The path of an entry: "straight", or an object with its kind, and the points or the velocities that it needs.
/// \throws FilmError that names the place.
first_contact::Path path_of(const Entry& entry);

/// How the knots of a curve through points are spaced: "catmull-rom", "centripetal" or "chordal".
/// \throws FilmError that names the place.
first_contact::Knots knots_of(const Entry& entry);

/// How a body is turned: {"axis": [x, y, z], "degrees": d}, or the four numbers of a quaternion, [w, x, y, z].
/// \throws FilmError that names the place.
first_contact::Quaternion turn_of(const Entry& entry);

/// A box, from its sides, its centre and its turn.
/// \throws FilmError that names the place.
first_contact::Box box_of(const Entry& entry);

}  // namespace tween_bounce
