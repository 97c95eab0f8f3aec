#pragma once
#include <string>

namespace first_contact {

/// Refuses what breaks a rule.
/// \throws std::invalid_argument with the message "what: rule", e.g. "masses: at most one may be infinite".
[[noreturn]] void refuse(const std::string& what, const std::string& rule);

/// Refuses a number.
/// \throws std::invalid_argument with the message "what value: rule", e.g. "mass -1: must be positive".
[[noreturn]] void refuse(const std::string& what, double value, const std::string& rule);

}  // namespace first_contact
