#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace first_contact::program {

/// Results in the order in which they were given.
using Json = nlohmann::ordered_json;

/// Prints with 17 significant digits, so that every double is read back as it was; what is not a number is
/// null.
std::string to_string(const Json& json);

/// The number of that place, as it is.
/// \throws std::invalid_argument if it is infinite or none, for which JSON has no word: so when it is told, before
///     anything is drawn.
double finite(double value, const std::string& place);

}  // namespace first_contact::program
