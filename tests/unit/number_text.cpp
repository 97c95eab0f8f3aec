#include "first_contact/geometry/number_text.hpp"

#include <limits>
#include <sstream>

#include "catch.hpp"

using namespace first_contact;

TEST_CASE("A number in a message is what a stream says of it") {
  for (const double value :
       {0.0, -0.0, 1.0, -2.5, 1 / 3.0, 1e5, 1e6, 123456.5, 1e-5, 1.07e301, 5e-324,
        std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    std::ostringstream stream;
    stream << value;
    CHECK(to_text(value) == stream.str());
  }
}
