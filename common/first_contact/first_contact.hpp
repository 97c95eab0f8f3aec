#pragma once

/// \file
/// All of the library at once, in the order in which it is read. What is compiled often includes only what it
/// needs.

// In reading order, which sorting by name would undo.
// clang-format off
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/space.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/fused.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/box_frame.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/geometry/frustum.hpp"
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/accurate_cross.hpp"
#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/weld.hpp"
#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/geometry/environment.hpp"

#include "first_contact/files/file_error.hpp"

#include "first_contact/mesh_io/mesh_defects.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"

#include "first_contact/sweep/moving.hpp"
#include "first_contact/sweep/contact.hpp"
#include "first_contact/sweep/obstacle.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/plane_error.hpp"
#include "first_contact/sweep/shared_middle.hpp"
#include "first_contact/sweep/separating_axes.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/first_root.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/nearest.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/first_touch.hpp"
#include "first_contact/sweep/known_environment.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/turning_mesh.hpp"
#include "first_contact/sweep/interval.hpp"
#include "first_contact/sweep/contact_times.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

#include "first_contact/trees/search.hpp"
#include "first_contact/trees/tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/ball_search.hpp"
#include "first_contact/trees/box_search.hpp"
#include "first_contact/trees/cast.hpp"
#include "first_contact/trees/collection.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/soup.hpp"
#include "first_contact/trees/bin_cut.hpp"
#include "first_contact/trees/plain_bvh.hpp"

#include "first_contact/bvh/bvh.hpp"

#include "first_contact/batch/batch.hpp"

#include "first_contact/pairs/space_time.hpp"
#include "first_contact/pairs/first_contacts.hpp"

#include "first_contact/response/slide.hpp"
#include "first_contact/response/impact.hpp"

#include "first_contact/motion/easing.hpp"
#include "first_contact/motion/curve.hpp"
#include "first_contact/motion/through_points.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/path.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/motion/bounce.hpp"

#include "first_contact/stage/hit_test.hpp"
// clang-format on
