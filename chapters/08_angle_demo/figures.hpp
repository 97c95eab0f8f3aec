#pragma once
#include "encounter.hpp"
#include "first_contact/program/program.hpp"

/// Two unit discs, one at rest, the other aimed one radius beside its centre: they meet at 30 degrees.
Encounter aimed_beside();

/// Two unit discs that touch, each moving aslant, with restitution 1/2: only what is along the line of
/// centres may change.
Encounter soft_and_aslant();

/// Before and after of the paper's four cases, its fourth case to scale, and where the normal is taken.
void draw_paper_cases(const first_contact::program::Program& program);

/// Two discs, how they come to meet or to miss each other, and where they go by one model or by both.
void draw_encounter(const first_contact::program::Program& program, const std::string& name,
                    const Encounter& encounter, bool printed, bool corrected);
