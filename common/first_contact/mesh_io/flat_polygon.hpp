#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

/// \file
/// Polygons in the plane, counterclockwise: what a face of a mesh file is, seen from its front. All answers are
/// exact.

namespace first_contact {

/// The corners, in order.
using FlatPolygon = std::vector<Eigen::Vector2d>;

/// Is it convex, and no three corners of a fan from the first one are on a line? Then that fan is a way to
/// cut it.
bool is_strictly_convex(const FlatPolygon& polygon);

/// Do two edges cross, each at a place within the other? Edges that only touch do not, nor do those that lie
/// on each other, as where a hole is joined to the outline. In O(n log n) for outlines that do not fold back
/// and forth.
bool crosses_itself(const FlatPolygon& polygon);

/// Cuts off ears, triangles that hold no other corner, until one triangle is left (G. H. Meisters, "Polygons
/// Have Ears", 1975). Corners on a straight line may make triangles without area. In O(n^2), O(n^3) if the
/// outline touches itself all along.
/// \return n - 2 triples of corners' numbers; fewer if it is no polygon, as it crosses itself or turns
/// clockwise.
std::vector<std::array<std::size_t, 3>> clip_ears(const FlatPolygon& polygon);

}  // namespace first_contact
