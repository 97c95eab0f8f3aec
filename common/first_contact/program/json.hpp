#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "first_contact/geometry/space.hpp"
#include "first_contact/sweep/contact.hpp"

namespace first_contact::program {

/// Results in the order in which they were given.
using Json = nlohmann::ordered_json;

/// A point or vector as [x, y, z].
Json to_json(const Vector& value);
/// The points of a contact, one list each.
Json to_json(const ContactPoints& points);
/// Prints with 17 significant digits, so that every double is read back as it was; what is not a number is null.
std::string to_string(const Json& json);

}  // namespace first_contact::program
