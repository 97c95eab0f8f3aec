#pragma once
#include "first_contact/geometry/box.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the boxes share a point? They are solid. Touching counts, up to rounding.
bool overlap(const Box& a, const Box& b);

/// First contact of a moving box with a box at rest, by separating axes: along each of 15 directions there is
/// an interval of time in which they do not lie apart; they touch when the last one begins, if none has ended
/// then. Boxes that overlap at the start are judged along the shortest way out.
///
/// The normal is that direction, the point the middle of the piece that they share, the feature what of the
/// obstacle is touched.
///
/// Error: t is the exact time for boxes that are moved apart or together by at most 16 eps L along the normal,
/// L being the largest distance of a vertex from the obstacle's first one, or |V| if that is longer. So its
/// error is at most 16 eps L / |N.V|, and boxes that go as deep as that are never missed.
/// \see tests/oracle/box_box.cpp
std::optional<Contact> sweep(const Moving<Box>& moving, const Box& obstacle);

}  // namespace first_contact
