#pragma once
#include <string>

namespace first_contact {

/// A number as a message says it: with six digits at most, "0.333333", "1e+300", "inf", "nan".
std::string to_text(double value);

}  // namespace first_contact
