#pragma once
#include <array>
#include <optional>
#include <vector>

#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// The scenes of chapter 4.
namespace general_sphere_chapter {

/// A cube with one corner cut off, so that it has every kind of feature; its sides are 1.6 long.
first_contact::Mesh cut_cube();

/// A prism along y whose section has six corners, one of them turned inwards, (x, z) in this order: two triangles
/// for each side, then its ends.
first_contact::Mesh prism();
std::vector<first_contact::Vector2> section_of_prism();

/// A floor and a step upon it. Two of its faces look up: the floor's come first in the list.
first_contact::Mesh step();

/// The axis of the paper's cylinder about a ridge of a solid, taken literally: the edge of the *moved-out* solid, at
/// the distance r from both faces.
std::optional<std::array<first_contact::Point, 2>> printed_axis(const first_contact::Environment& environment,
                                                                const first_contact::MeshEdges::Edge& edge,
                                                                double radius);

/// The time at which a sphere's centre meets that cylinder.
std::optional<double> time_of_printed_cylinder(const first_contact::Moving<first_contact::Sphere>& moving,
                                               const first_contact::Environment& environment,
                                               const first_contact::MeshEdges::Edge& edge);
/// The earliest of the paper's cylinders.
std::optional<double> printed_time(const first_contact::Moving<first_contact::Sphere>& moving,
                                   const first_contact::Environment& environment);

/// The paper's order taken literally: the first face of the list that is hit ends the search.
std::optional<first_contact::Contact> first_face_in_the_list(
    const first_contact::Moving<first_contact::Sphere>& moving, const first_contact::Mesh& mesh);

}  // namespace general_sphere_chapter
