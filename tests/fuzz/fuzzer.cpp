// A fuzzer of one target, for libFuzzer: ./course fuzz.
#include <cstddef>
#include <cstdint>
#include <string>

#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  for (const Target& target : all_targets())
    if (target.name == FUZZ_TARGET) target.feed(bytes);
  return 0;
}
