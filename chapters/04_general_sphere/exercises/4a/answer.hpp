#include "task.hpp"

// The first t >= 0 at which m + tv, which starts outside of the sphere of radius r about 0, meets it; else
// {}.
std::optional<double> first_root(Vector m, Vector v, double r) { return {}; }
