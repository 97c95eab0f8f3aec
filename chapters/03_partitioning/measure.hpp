#pragma once
#include <optional>
#include <vector>

#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"
#include "room.hpp"

/// What one structure did for many flights.
struct Cost {
  std::size_t nodes = 0, depth = 0;  ///< of the structure
  std::size_t work = 0;              ///< objects looked at to build it
  std::size_t tests = 0;             ///< of a ball against one triangle, over all flights
  std::size_t hits = 0;              ///< flights that end at a triangle
  std::size_t looked_at = 0;         ///< nodes, over all flights
  std::vector<std::optional<first_contact::Contact>> contacts = {};  ///< one a flight

  /// Over all flights, the mean.
  double per_flight(std::size_t total) const {
    return contacts.empty() ? 0 : static_cast<double>(total) / static_cast<double>(contacts.size());
  }
};

//! [measure]
/// The first contact of every flight, and what it took to find it.
template <first_contact::Partition Tree>
Cost measure(const first_contact::Soup<Tree>& soup,
             const std::vector<first_contact::Moving<first_contact::Sphere>>& flights) {
  Cost cost;
  cost.nodes = soup.tree().nodes();
  cost.depth = soup.tree().depth();
  cost.work = soup.tree().work();
  for (const auto& ball : flights) {
    first_contact::Statistics counted;
    cost.contacts.push_back(sweep(ball, soup, &counted));
    cost.tests += counted.tests;
    cost.looked_at += counted.nodes;
    cost.hits += cost.contacts.back().has_value();
  }
  return cost;
}
//! [measure]

/// Do two structures give the same contacts, to the last bit?
bool same_contacts(const Cost& a, const Cost& b);

/// How deep the objects of a tree lie: the paper's time to find one of k (1.4).
struct Depth {
  double mean;
  std::size_t deepest;
};
Depth depth_of_objects(const first_contact::Octree& tree);
Depth depth_of_objects(const first_contact::BspTree& tree);
Depth depth_of_objects(const first_contact::BoxTree& tree);

/// log_8 k; 0 for k < 1.
double log8(std::size_t k);

/// Of the pairs of boxes that overlap, those that share a leaf of an octree: all that a search finds that
/// goes down into one child only.
struct Pairs {
  std::size_t all, in_one_leaf;
};
Pairs overlapping_pairs(const std::vector<first_contact::Bounds>& boxes);
