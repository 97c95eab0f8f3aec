#pragma once
#include "first_contact/program/program.hpp"

namespace tween_bounce {

/// What the notes tell of the film's first curve, its chords, and of what breaks that which one writes first.
void note_plain(first_contact::program::Program& program);

}  // namespace tween_bounce
