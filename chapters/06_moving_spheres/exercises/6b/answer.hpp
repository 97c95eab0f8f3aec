#include "task.hpp"

// The t in [0, 1] at which w + tu, apart from the ball of radius d about 0 at the start, first meets it; else
// {}.
std::optional<float> meet(const Float3& w, const Float3& u, float d) { return {}; }
