#pragma once
#include "first_contact/geometry/plane.hpp"
#include "workbook/vectors.hpp"

/// What the library has as what the workbook has, for `./course run plane --mine`.
namespace mine {

inline workbook::Vector vector(const first_contact::Vector& v) { return {v.x(), v.y(), v.z()}; }
inline workbook::Plane plane(const first_contact::Plane& E) { return {vector(E.normal()), E.offset()}; }
inline first_contact::Vector vector(const workbook::Vector& v) { return {v.x, v.y, v.z}; }

}  // namespace mine
