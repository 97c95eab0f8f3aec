#pragma once
#include <functional>

#include "workbook/value.hpp"

namespace workbook {

/// The plainest input that still fails: lists lose parts, numbers become 0, 1 or short ones, as long as it
/// fails.
Value shrunk(Value input, const std::function<bool(const Value&)>& fails);

}  // namespace workbook
