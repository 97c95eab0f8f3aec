#pragma once
// How the mathematics speaks to the page: what a figure asks is an exported function of plain numbers, what it
// is answered are numbers by name, the names that the chapter's program gives them in --json.
#include <cstdint>
#include <span>

#include "first_contact/geometry/space.hpp"

/// A function that the page calls by its name.
#define FOR_THE_PAGE(name) extern "C" __attribute__((export_name(#name))) void name

namespace touch {

/// "contact/time" is the time of the contact, as in JSON pointers. What the program does not print, and the page
/// needs for its drawing, is called "drawn/...".
void tell(const char* name, double value);
void tell(const char* name, const first_contact::Vector& value);
void tell(const char* name, std::span<const double> values);
void tell(const char* name, const char* word);
void tell_whether(const char* name, bool is_so);

}  // namespace touch
