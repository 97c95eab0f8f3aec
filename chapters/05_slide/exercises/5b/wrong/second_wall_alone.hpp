// Looks like: only the wall M is looked at.
// Ask: which of your answers depends on N?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) { return w - std::min(0.0, dot(w, M)) * M + 0 * N; }
