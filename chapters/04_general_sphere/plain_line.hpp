#pragma once
#include "first_contact/geometry/space.hpp"

/// A line through a triangle, as one writes it first: right while the triangle is not far away for its size.

namespace general_sphere_chapter {

/// Does the line through the origin along v meet the triangle a b c?
bool plain_line_meets(const first_contact::Vector& v, const first_contact::Vector& a,
                      const first_contact::Vector& b, const first_contact::Vector& c);

/// Lines aimed at triangles of about the size 1 from so far away.
struct FarLines {
  int lines;
  int missed;             ///< as one writes it first
  int missed_by_library;  ///< by `weights_where_line_meets`
};
/// A thousand, each at a place within a triangle of its own.
FarLines lines_from(double distance);

}  // namespace general_sphere_chapter
