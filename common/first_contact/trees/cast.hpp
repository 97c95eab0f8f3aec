#pragma once
#include <span>

#include "first_contact/geometry/triangle.hpp"
#include "first_contact/trees/ball_search.hpp"

namespace first_contact {

/// A moving ball among triangles: which does it touch first? Of equal times the face wins before the edge
/// before the vertex, and then the triangle with the lowest number, so that the order in which a tree shows
/// them does not matter. What lies beyond the first contact that is known so far is not searched.
class Cast : public BallSearch {
 public:
  /// \param triangles they must outlive the search;
  /// \param scene their bounds
  Cast(const Moving<Sphere>& ball, std::span<const Triangle> triangles, const Bounds& scene);

  /// The first contact, if there is one.
  const std::optional<Contact>& contact() const { return first_; }

 private:
  bool hit(std::size_t triangle) override;

  std::span<const Triangle> triangles_;
  std::optional<Contact> first_;
};

}  // namespace first_contact
