#pragma once
#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// The scenes of chapter 4.
namespace general_sphere_chapter {

/// A cube with one corner cut off, so that it has every kind of feature; its sides are 1.6 long.
first_contact::Mesh cut_cube();

/// A floor and a step upon it. Two of its faces look up: the floor's come first in the list.
first_contact::Mesh step();

/// The paper's cylinder about a ridge of a solid, taken literally: its axis is the edge of the *moved-out*
/// solid, at the distance r from both faces. The time at which a sphere's centre meets it.
std::optional<double> time_of_printed_cylinder(const first_contact::Moving<first_contact::Sphere>& moving,
                                               const first_contact::Environment& environment,
                                               const first_contact::MeshEdges::Edge& edge);

/// The paper's order taken literally: the first face of the list that is hit ends the search.
std::optional<first_contact::Contact> first_face_in_the_list(
    const first_contact::Moving<first_contact::Sphere>& moving, const first_contact::Mesh& mesh);

}  // namespace general_sphere_chapter
