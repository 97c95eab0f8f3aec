#pragma once
#include <string>

#include "encounter.hpp"
#include "first_contact/program/program.hpp"

/// The figures of the paper's four cases: all of them, the fourth to scale, where the normal is taken, and
/// what restitution does.
void draw_paper_cases(const first_contact::program::Program& program);

/// Velocities before and after the impact in the four cases of program 4.
void draw_cases(const first_contact::program::Program& program);

/// Two discs, how they come to meet or to miss each other, and where they go by one model or by both.
void draw_encounter(const first_contact::program::Program& program, const std::string& name,
                    const Encounter& encounter, bool printed, bool corrected);

/// Restitution 1/2: as printed, the velocities across the line of centres shrink as well.
void draw_drag(const first_contact::program::Program& program);
