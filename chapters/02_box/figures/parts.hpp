#pragma once
#include <numbers>
#include <string>
#include <vector>

#include "first_contact/figure/scene.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/sweep/contact.hpp"

/// What several drawings of boxes on planes have in common.

inline constexpr double degree = std::numbers::pi / 180;

inline const first_contact::figure::Pen plane_edge{first_contact::figure::colour::blue, 1.2};
inline const first_contact::figure::Pen offset_edge{first_contact::figure::colour::grey, 1.2, true};
inline const first_contact::figure::Fill plane_fill{first_contact::figure::colour::floor, 1, false,
                                                    plane_edge};
inline const first_contact::figure::Fill offset_fill{first_contact::figure::colour::floor, 0, false,
                                                     offset_edge};
inline const first_contact::figure::Fill solid{first_contact::figure::colour::amber, 1, true};
inline const first_contact::figure::Fill glass{first_contact::figure::colour::amber, 0.5, true};

/// The foot of a point on a plane.
first_contact::Point on(const first_contact::Plane& plane, const first_contact::Point& p);

/// The outline of a box seen along the plane's normal, on the plane: from each direction the farthest vertex.
std::vector<first_contact::Point> shadow(const first_contact::Box& box, const first_contact::Plane& plane);

/// C, or C_1, C_2, ... if several points touch.
std::string name_of(const first_contact::ContactPoints& points, Eigen::Index i);

/// What touches, on top of all: the vertex, the edge with its ends, or the face with its corners.
void mark_contact(first_contact::figure::Scene& scene, const first_contact::ContactPoints& points);
