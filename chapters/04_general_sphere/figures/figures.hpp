#pragma once
#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// All figures of the chapter.
void draw_general_sphere_figures(const first_contact::program::Program& program,
                                 const first_contact::Environment& environment,
                                 const first_contact::Moving<first_contact::Sphere>& moving,
                                 const std::optional<first_contact::Contact>& contact);

/// Figure 6: the centres of all spheres in contact with a solid lie on the solid moved out by r, round at its
/// corners.
void draw_moved_out(const first_contact::figure::Studio& studio);
/// Figure 7: the path meets the moved-out face at A before it comes to the cylinder, inside, at B.
void draw_face_first(const first_contact::figure::Studio& studio);
/// Figure 8: in a valley the cylinder about the edge lies wholly within the moved-out solid.
void draw_valley(const first_contact::figure::Studio& studio);
/// Figure 9: the vertex A, where the bottom of a jar begins to rise, has its ball within the moved-out jar.
void draw_jar(const first_contact::figure::Studio& studio);
/// The face as it is seen along the motion of the lowest point: within it, and beside it.
void draw_lowest_point(const first_contact::program::Program& program);
/// As printed, the cylinder's axis is moved out as well, and the ball stops in the air.
void draw_printed_cylinder(const first_contact::program::Program& program);
/// The paper's order, taken literally: the floor comes first in the list, and the ball is let through the
/// step above it.
void draw_order(const first_contact::program::Program& program);
/// All faces, edges and vertices moved out: the Minkowski sum of the solid and a ball.
void draw_minkowski_sum(const first_contact::figure::Studio& studio);
/// A ray against a triangle: through the face, and exactly through an edge.
void draw_ray(const first_contact::figure::Studio& studio);
/// Balls flung at the bunny from all around, where they first touch it: on a face, an edge or a vertex.
void draw_bunny(const first_contact::program::Program& program);
/// Figure 16: the jaw as it closes, and opened until it touches the cheek bone.
void draw_jaw(const first_contact::program::Program& program);
/// The sweep of this run.
void draw_sweep(const first_contact::figure::Studio& studio, const first_contact::Environment& environment,
                const first_contact::Moving<first_contact::Sphere>& moving,
                const std::optional<first_contact::Contact>& contact);
/// Errors of the edge's formulas, and wrong answers of the ray's, as charts.
void draw_accuracy(const first_contact::program::Program& program);
