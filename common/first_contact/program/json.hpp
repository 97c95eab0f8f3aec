#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace first_contact::program {

/// Results in the order in which they were given.
using Json = nlohmann::ordered_json;

/// Prints with 17 significant digits, so that every double is read back as it was; what is not a number is
/// null.
std::string to_string(const Json& json);

/// The place of a number that is infinite or none, as a JSON pointer; empty if there is no such number.
std::string beyond_all_numbers(const Json& json);

}  // namespace first_contact::program
