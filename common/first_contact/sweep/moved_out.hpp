#pragma once
#include <optional>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// The three surfaces on which the centre of a sphere lies when it touches a polyhedron (paper, 2.1): the
/// faces moved out by r, cylinders of radius r about the edges, and spheres of radius r about the vertices.
/// The paper's text puts the axes and the centres on the polyhedron that was moved out; they belong on the
/// original edges and vertices.

namespace first_contact {

/// How a moving sphere touches one face, one edge or one vertex.
struct Touch {
  double time;      ///< t in [0, 1]
  double distance;  ///< from the feature to the centre at that time: r, or less if they overlap at the start
  Vector normal;    ///< unit, from the feature to the centre
  Point point;      ///< on the feature
  /// Which of the three it is.
  Feature feature;
  double tolerance;  ///< how far rounding may have moved the distance
};

/// The centre meets the face moved out by r, on the side where it starts: t = -(E'.S0) / (N.V), if it arrives
/// within the face. A sphere that overlaps the face at the start, its centre over the face, touches at t = 0
/// if it goes deeper.
/// \param surely_within  the caller knows that it arrives within the face, far enough from the sides for any
/// rounding: then that is not asked once more
std::optional<Touch> touch_face(const Moving<Sphere>& moving, const Facet& facet, bool surely_within = false);

/// The centre enters the cylinder of radius r about the edge ab, between its two ends.
std::optional<Touch> touch_edge(const Moving<Sphere>& moving, const Point& a, const Point& b);

/// The centre enters the sphere of radius r about a vertex.
std::optional<Touch> touch_vertex(const Moving<Sphere>& moving, const Point& vertex);

/// The smallest time wins; of equal times the face before the edge before the vertex, and then what is
/// nearer. Beyond that any fixed order will do that does not depend on the numbers of the triangles.
bool earlier(const Touch& a, const Touch& b);

}  // namespace first_contact
