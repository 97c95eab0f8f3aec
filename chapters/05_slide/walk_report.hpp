#pragma once
#include <vector>

#include "first_contact/program/program.hpp"
#include "walk.hpp"

/// Walks over all grounds and tells what is worst in each, as a table.
std::vector<walks::Walk> tell_walks(first_contact::program::Program& program,
                                    const std::vector<walks::Ground>& grounds, long frames);

/// Numbers of all walks together, that the notes speak of.
void note_walks(first_contact::program::Program& program, const std::vector<walks::Ground>& grounds,
                const std::vector<walks::Walk>& all);
