#pragma once
#include <algorithm>
#include <initializer_list>

#include "first_contact/geometry/space.hpp"

namespace first_contact::figure {

/// Brings a scene near the origin and to a size of about 1, whatever the caller's unit and place: so that
/// it can be drawn, with the few digits that a figure's script has.
struct Framing {
  Point origin = Point::Zero();  ///< what becomes the origin
  double unit = 1;               ///< what becomes 1

  /// About a point of the scene, so that no coordinate of these lengths is larger than 1.
  static Framing about(const Point& origin, std::initializer_list<Vector> lengths) {
    double unit = 0;
    for (const Vector& length : lengths) unit = std::max(unit, length.cwiseAbs().maxCoeff());
    return {origin, unit > 0 ? unit : 1};
  }
  /// The same, but a scene that can be drawn as it is, stays as it is.
  static Framing if_needed(const Point& origin, std::initializer_list<Vector> lengths) {
    const Framing framing = about(origin, lengths);
    const bool ordinary = framing.unit > 1.0 / 16 && framing.unit < 16;
    return ordinary && origin.cwiseAbs().maxCoeff() < 16 ? Framing{} : framing;
  }

  /// A point of the scene in the figure.
  Point point(const Point& p) const { return (p - origin) / unit; }
  /// A length, or a vector, of the scene in the figure.
  template <class Length>
  Length length(const Length& v) const {
    return v / unit;
  }
};

}  // namespace first_contact::figure
