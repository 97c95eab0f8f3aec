#pragma once
#include <string>

#include "first_contact/program/program.hpp"

namespace tween_bounce {

/// What is asked about a film on the command line.
struct FilmOptions {
  /// Adds these options to a program's, which fills them in as it runs.
  explicit FilmOptions(first_contact::program::Program& program);
  FilmOptions(const FilmOptions&) = delete;
  FilmOptions& operator=(const FilmOptions&) = delete;

  std::string word;        ///< a built-in film, or a file; empty: none is asked for
  double per_second = 25;  ///< pictures
  double at = 0;           ///< where it is frozen, if that is asked for
};

/// Tests, tells, writes and draws a film, if one is asked for.
/// \param table  the file for its pictures as numbers, or empty
/// \return was there a film?
bool run_film(first_contact::program::Program& program, const FilmOptions& options, const std::string& table);

}  // namespace tween_bounce
