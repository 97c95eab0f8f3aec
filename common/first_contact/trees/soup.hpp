#pragma once
#include <optional>

#include "first_contact/trees/cast.hpp"
#include "first_contact/trees/collection.hpp"

namespace first_contact {

/// Many triangles, each for itself, and the tree that finds them: `Soup<Octree>`, `Soup<BspTree>`,
/// `Soup<BruteForce>`. (Triangles that make up a surface are an environment, chapter 4: there an edge between
/// two faces is judged by both.)
template <Partition Tree>
using Soup = Collection<Triangle, Tree>;

//! [sweep_soup]
/// First contact of a moving sphere with many triangles: the smallest t over all; of equal t the face before
/// the edge before the vertex, then the triangle with the lowest number. Bit for bit the same for every tree,
/// as long as rounding moves a contact by less than `search_margin` along the motion.
/// \param counted if given, it is told what the search did
template <Partition Tree>
std::optional<Contact> sweep(const Moving<Sphere>& ball, const Soup<Tree>& soup,
                             Statistics* counted = nullptr) {
  Cast cast(ball, soup.all(), soup.bounds());
  ask(soup, cast, counted);
  return cast.contact();
}
//! [sweep_soup]

/// The largest coordinate of a corner: how far the rounding of a sweep may go is relative to it.
template <Partition Tree>
double largest_coordinate(const Soup<Tree>& soup) {
  return largest_coordinate(soup.bounds());
}

}  // namespace first_contact
