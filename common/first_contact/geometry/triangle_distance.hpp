#pragma once
#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// Two points, one of each of two shapes, that are as near to each other as any two are.
struct NearestPoints {
  ///@{
  /// The point of the first shape, and that of the second.
  Point first, second;
  ///@}

  /// How far apart they are.
  double distance() const;
};

/// The nearest points of the segments ab and cd (Ericson, Real-Time Collision Detection, 5.1.9). Either may
/// be a point.
NearestPoints nearest_points(const Point& a, const Point& b, const Point& c, const Point& d);

/// The nearest points of two triangles; where they cross, a point that both have. Unless they cross, an edge
/// is nearest to an edge or a corner to a face, so that nine and six tests decide. They may be degenerate.
NearestPoints nearest_points(const Triangle& first, const Triangle& second);

}  // namespace first_contact
