#pragma once
#include <array>
#include <string>

#include "first_contact/figure/scene.hpp"

/// What several drawings of two discs have in common.

/// The discs' plane is the picture.
inline constexpr first_contact::figure::View above{0, 0};
inline const std::array<first_contact::figure::Colour, 2> body{first_contact::figure::colour::amber,
                                                               first_contact::figure::colour::sky};

/// A point of the discs' plane in space.
first_contact::Point flat(const Eigen::Vector2d& v);

/// With a true minus sign.
std::string number_text(double value, const char* form);
std::string angle_text(double degrees);

void add_disc(first_contact::figure::Scene& scene, const Eigen::Vector2d& center, double radius,
              const first_contact::figure::Colour& colour, double opacity);

/// A text beyond an arrow's tip: its side if the arrow is steep, and the room that it needs.
struct Name {
  std::string text;
  double room = 0;
  first_contact::figure::Align side = first_contact::figure::Align::centre;
};

/// A velocity as an arrow that begins at a body's rim.
void add_velocity(first_contact::figure::Scene& scene, const Eigen::Vector2d& center, double rim,
                  const Eigen::Vector2d& velocity, const first_contact::figure::Colour& colour,
                  const Name& name = {});
