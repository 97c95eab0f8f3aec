#pragma once
#include <filesystem>
#include <string>

#include "first_contact/figure/figure.hpp"

namespace first_contact::figure {

/// The program that draws: a name is looked for where programs are, a path is taken as it is. Empty if there
/// is no such program.
std::filesystem::path find_gnuplot(const std::string& name);

/// Runs gnuplot on a script, in the script's folder, as a child that does not outlive this program.
/// \throws std::runtime_error with gnuplot's status and words if it fails or complains, or is not done in
///     time.
/// \throws Interrupted if this program is to end meanwhile.
void run_gnuplot(const std::filesystem::path& program, const Studio& studio,
                 const std::filesystem::path& script, const std::string& format);

}  // namespace first_contact::figure
