#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace first_contact {

/// The double nearest to a number in C's decimal notation, "-12.5e3", or to "inf" and "nan" in any case,
/// whatever the locale. Beyond the range of double it is infinite; what is too small for it is 0 or as near
/// as can be.
/// \return nothing if any of the text is something else: a plus sign, a blank, a unit.
std::optional<double> decimal(std::string_view text);

/// The fewest digits that are read back as the same double.
std::string shortest(double value);

}  // namespace first_contact
