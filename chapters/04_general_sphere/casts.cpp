#include "casts.hpp"

#include <cstdio>
#include <sstream>

#include "first_contact/files/input.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/program/numbers.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

namespace {

Moving<Sphere> cast_of(const std::string& line) {
  const auto c = program::numbers_of(line, 7);
  const Point from(c[0], c[1], c[2]), to(c[3], c[4], c[5]);
  return {{from, c[6]}, to - from};
}

std::string line_of(const std::optional<Contact>& contact) {
  if (!contact) return "0,,,,,,,,,\n";
  const Point p = contact->point();
  const Vector& n = contact->normal;
  char text[256];
  std::snprintf(text, sizeof text, "1,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%s,%zu\n", contact->time,
                p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), to_string(contact->feature), contact->triangle);
  return text;
}

}  // namespace

Casts read_casts(const std::string& file) {
  std::istringstream in(without_byte_order_mark(read_file(file)));
  Casts casts{false, {}};
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty()) continue;
    if (number == 1 && line == "x0,y0,z0,x1,y1,z1,r") {
      casts.with_header = true;
      continue;
    }
    try {
      casts.moving.push_back(cast_of(line));
    } catch (const std::exception& error) {
      throw std::runtime_error("line " + std::to_string(number) + ", \"" + printable(line) +
                               "\": " + error.what());
    }
  }
  if (casts.moving.empty()) throw std::runtime_error("must hold at least one cast");
  return casts;
}

std::string results_of(const Casts& casts, const Environment& environment) {
  std::string text = casts.with_header ? "hit,time,px,py,pz,nx,ny,nz,feature,triangle\n" : "";
  for (std::size_t i = 0; i < casts.moving.size(); ++i) {
    const auto contact = sweep(casts.moving[i], environment);
    if (contact && !(contact->normal.allFinite() && contact->point().allFinite()))
      throw std::runtime_error("cast " + std::to_string(i + 1) + ": must stay within the range of numbers");
    text += line_of(contact);
  }
  return text;
}

}  // namespace general_sphere_chapter
