#pragma once
#include <optional>
#include <sstream>
#include <string>

#include "first_contact/sweep/contact.hpp"

/// \file
/// Are two answers of a sweep the same to the last bit?

namespace first_contact {

inline bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (a.has_value() != b.has_value()) return false;
  return !a || (a->time == b->time && a->points == b->points && a->normal == b->normal &&
                a->feature == b->feature && a->triangle == b->triangle);
}

/// In words, for a test that fails.
inline std::string told(const std::optional<Contact>& c) {
  if (!c) return "nothing";
  std::ostringstream out;
  out.precision(17);
  out << c->time << ' ' << c->feature << ' ' << c->triangle << " at " << c->point().transpose() << " normal "
      << c->normal.transpose();
  return out.str();
}

}  // namespace first_contact
