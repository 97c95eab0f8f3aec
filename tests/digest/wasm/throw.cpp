// WebAssembly of Debian's clang knows no exceptions: what would be thrown ends the program, with its message.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <typeinfo>

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_free_exception(void*) noexcept {}
[[noreturn]] void __cxa_throw(void* thrown, std::type_info*, void (*)(void*)) {
  std::fprintf(stderr, "thrown: %s\n", static_cast<std::exception*>(thrown)->what());
  std::abort();
}

}  // extern "C"
