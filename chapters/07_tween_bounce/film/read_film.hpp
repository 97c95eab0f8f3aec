#pragma once
#include <filesystem>
#include <string>

#include "film.hpp"

namespace tween_bounce {

/// The largest film file, in bytes.
inline constexpr std::size_t most_bytes = 1 << 20;

/// Reads a film from its text. Meshes are looked for from `folder`.
/// \throws FilmError that names the place, the value and the rule.
Film film_of(const std::string& text, const std::string& name, const std::filesystem::path& folder);

/// The film of that word: one of `scenes`, the text of one, which begins with {, or else a file.
/// \throws FilmError, or FileError if there is no such file.
Film film_named(const std::string& word);

}  // namespace tween_bounce
