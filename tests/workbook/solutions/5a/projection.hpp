#include "task.hpp"

Vector slide_along(Vector w, Vector N) { return w - std::min(0.0, dot(w, N)) / dot(N, N) * N; }
