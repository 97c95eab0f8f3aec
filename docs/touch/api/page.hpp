#pragma once
// How the mathematics speaks to the page: what a figure asks is an exported function of plain numbers, what it
// is answered are numbers by name, the names that the chapter's program gives them in --json.
#include <span>
#include <string_view>
#include <vector>

#include "first_contact/geometry/space.hpp"

/// A function that the page calls by its name.
#define FOR_THE_PAGE(name) extern "C" __attribute__((export_name(#name))) void touch_##name

namespace touch {

/// "contact/time" is the time of the contact, as in JSON pointers. What the program does not print, and the page
/// needs for its drawing, is called "drawn/...".
void tell(std::string_view name, double value);
void tell(std::string_view name, const first_contact::Vector& value);
void tell(std::string_view name, std::span<const double> values);
void tell(std::string_view name, const char* word);
void tell_whether(std::string_view name, bool is_so);

/// Numbers that the page has by that name: a mesh is not a part of the module.
std::vector<double> given(std::string_view name);

}  // namespace touch
