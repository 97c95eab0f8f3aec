#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <limits>
#include <type_traits>

/// A number of 64 bits or more, for tests that judge doubles: the processor's own `long double` where it has as many
/// (x86, and Linux on ARM), else, where that is but a double, one that is worked out.
using Wide = std::conditional_t<(std::numeric_limits<long double>::digits >= 64), long double,
                                boost::multiprecision::cpp_bin_float_double_extended>;
