#pragma once
#include <string>

namespace first_contact::figure {

/// What is to be said if the system has not the letters that pictures of dots are drawn with; empty if it
/// has, or if it cannot be asked.
std::string missing_letters(bool chinese);

}  // namespace first_contact::figure
