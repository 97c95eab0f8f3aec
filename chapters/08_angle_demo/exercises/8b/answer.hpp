#include "task.hpp"

// The two discs after one unit of time: they go on straight, bounce off each other if they meet, and go on.
Discs step(const Discs& discs) { return {}; }
