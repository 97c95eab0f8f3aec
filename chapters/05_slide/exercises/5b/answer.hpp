#include "task.hpp"

// The motion nearest to w that leads into neither of two walls with the normals N and M, of length 1.
Vector along_two_walls(Vector w, Vector N, Vector M) { return {}; }
