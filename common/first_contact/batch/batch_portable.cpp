#include "first_contact/batch/batch_loops.inc"

namespace first_contact::batch {
const Loops portable_loops{sphere_sphere_loop, sphere_plane_loop, box_plane_loop};
}
