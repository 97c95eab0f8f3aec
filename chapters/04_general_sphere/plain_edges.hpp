#pragma once
#include <vector>

#include "first_contact/geometry/mesh_edges.hpp"

/// How a surface bends at an edge, and whether a vertex is buried, as one writes it first: right where
/// nothing is rounded.

namespace general_sphere_chapter {

/// How two faces with these normals meet, along their edge as the first one goes.
first_contact::EdgeKind plain_kind(const first_contact::Vector& n, const first_contact::Vector& m,
                                   const first_contact::Vector& along);

/// Is there no direction that leads away from all edges of a vertex? They lead away from it, and are not all
/// in one plane.
bool plain_buried(const std::vector<first_contact::Vector>& edges);

/// What becomes of the solid of the scene, which has seams and no buried corner, when it is turned.
struct TurnedSolids {
  int seams = 0, seams_felt = 0;        ///< of all of them, those that are said not to be flat
  int corners = 0, corners_buried = 0;  ///< of all of them, those that are said to be buried
};
/// So many times, each in a way of its own.
TurnedSolids turned_solids(int times);

}  // namespace general_sphere_chapter
