#pragma once
#include <string>
#include <vector>

#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// Many casts at once, from a table of comma-separated values and into another.
namespace general_sphere_chapter {

/// The casts of a table, and whether its first line names the columns.
struct Casts {
  bool with_header;
  std::vector<first_contact::Moving<first_contact::Sphere>> moving;
};

/// Reads a table with the columns x0,y0,z0,x1,y1,z1,r: start, end and radius of a cast in each line. A first
/// line with just these names is a header; empty lines are passed over.
/// \throws std::runtime_error that names the line, its value and the rule.
Casts read_casts(const std::string& file);

/// The results, a line a cast: hit,time,px,py,pz,nx,ny,nz,feature,triangle, with 17 significant digits; hit
/// is 1, or 0 with all the rest empty. A header if the casts had one.
std::string results_of(const Casts& casts, const first_contact::Environment& environment);

}  // namespace general_sphere_chapter
