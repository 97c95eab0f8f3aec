#pragma once
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/turning_mesh.hpp"

/// The question of the paper's figure 16 (3.2.4): a jaw opens; does its coronoid process, the spur in front
/// of the joint, touch the cheek bone?
namespace jaw {

/// How high the coronoid process stands above the hinge: as it should, and grown too long.
inline constexpr double usual = 0.75, grown = 1.75;

/// A jaw with spurs of this height, the hinge through the origin along y, the chin in front at x = 4.7.
first_contact::Mesh jaw_bone(double spur);
/// The cheek bone with its arch, on the side y < 0 or y > 0.
first_contact::Mesh cheek_bone(double side);
/// The jaw opens by this angle: 40 degrees.
extern const double opening;
/// The jaw with a spur of this height, on its way from closed to open.
first_contact::Turning<first_contact::Mesh> opening_jaw(double spur);

/// The lines of the report, and the numbers that the notes speak of.
void tell(first_contact::program::Program& program);

}  // namespace jaw
