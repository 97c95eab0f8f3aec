#pragma once
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Many moving spheres: which of them meet, and when? Every pair is asked for as if the others were not
/// there, in time [0, 1].

namespace first_contact {

/// Two of many spheres, and how they first touch.
struct PairContact {
  std::size_t first;   ///< the mover
  std::size_t second;  ///< the obstacle: a higher number
  Contact contact;     ///< sweep(spheres[first], spheres[second])
};

/// What finding the pairs took.
struct PairStatistics {
  std::size_t pieces = 0;  ///< into which the motions were cut
  std::size_t boxes = 0;   ///< tests of a box against another
  std::size_t sweeps = 0;  ///< pairs of spheres that were swept themselves
};

/// The plain version, to read and to test by: sweeps every pair, n (n - 1) / 2 of them. All contacts in the
/// order of their times; of equal times, of the numbers.
std::vector<PairContact> first_contacts_one_by_one(std::span<const Moving<Sphere>> spheres);

/// The same contacts, in the same order, bit for bit; for spheres that each come near but few others, in a
/// time that grows like n log n, whatever their sizes and speeds.
///
/// Spheres can only meet where the boxes about their motions overlap. A fast one's box would be nearly empty:
/// its motion is cut into pieces, each with its place and its time. Pairs of pieces are found by
/// show_overlaps(); those spheres are swept. A contact counts in the pieces in which it happens: so each is
/// found once, in however many pieces two spheres come near each other.
std::vector<PairContact> first_contacts(std::span<const Moving<Sphere>> spheres,
                                        PairStatistics* counted = nullptr);

/// The first of them all, which is where a simulation has to stop; nothing if no two spheres meet.
std::optional<PairContact> earliest_contact(std::span<const Moving<Sphere>> spheres,
                                            PairStatistics* counted = nullptr);

/// By how much the box about a piece of a motion is grown, in units of |S| + |V| + r (largest coordinates):
/// the sweep may find a contact at a time, rounded, when the spheres are still apart by a little.
///
/// At that time the distance is at most d + 8 eps |w| + 24 eps d + eps |u|: the error of t that
/// sphere_sphere.hpp states moves P along its path by e = 8 eps (|w| + d^2 / h), and that raises the distance
/// by h e / d + e^2 / 2d, or less. With |w| at most sqrt(3) times the sum of the largest coordinates, that is
/// 14 eps |S| + 24 eps r + 2 eps |V| for each of the two spheres; the rounding of the box takes 2 eps more of
/// each; and the next power of two is taken. (To which some smallest doubles are added, for scenes that are hardly
/// larger.)
///
/// \see tests/property/first_contacts.cpp
inline constexpr double box_margin = 32 * std::numeric_limits<double>::epsilon();

}  // namespace first_contact
