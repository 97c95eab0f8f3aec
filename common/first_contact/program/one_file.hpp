#pragma once
#include <string>

namespace first_contact::program {

/// Do two names lead to one and the same plain file, be it there already or not? What is written must not take
/// the place of what is read. A device may be both: what is read from a terminal may be answered there.
bool are_one_file(const std::string& one, const std::string& other);

}  // namespace first_contact::program
