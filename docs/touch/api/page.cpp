#include "page.hpp"

#include <array>
#include <cstdlib>
#include <exception>
#include <string>
#include <typeinfo>

#include "first_contact/geometry/number_text.hpp"

#define OF_THE_PAGE(name) __attribute__((import_module("page"), import_name(name)))

extern "C" {

OF_THE_PAGE("numbers")
void page_numbers(const char* name, std::size_t length, const double* values, std::size_t count);
OF_THE_PAGE("number") void page_number(const char* name, std::size_t length, double value);
OF_THE_PAGE("word") void page_word(const char* name, std::size_t length, const char* word);
OF_THE_PAGE("whether") void page_whether(const char* name, std::size_t length, bool is_so);
OF_THE_PAGE("count") std::size_t page_count(const char* name, std::size_t length);
OF_THE_PAGE("copy") void page_copy(const char* name, std::size_t length, double* to);
OF_THE_PAGE("text") std::size_t page_text(double value, char* to, std::size_t most);
OF_THE_PAGE("refused") void page_refused(const char* why);

// WebAssembly of Debian's clang knows no exceptions: what would be thrown is told to the page, and the call
// ends there.
void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_free_exception(void*) noexcept {}
[[noreturn]] void __cxa_throw(void* thrown, std::type_info*, void (*)(void*)) {
  page_refused(static_cast<std::exception*>(thrown)->what());
  __builtin_trap();
}
// A fault that cannot be; the library's own words for it would bring all of printf.
[[noreturn]] void abort_message(const char*, ...) { __builtin_trap(); }

}  // extern "C"

// What a refusal says of a number is written by the page, for the same reason.
std::string first_contact::to_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), page_text(value, text.data(), text.size())};
}

namespace touch {

void tell(std::string_view name, double value) { page_number(name.data(), name.size(), value); }
void tell(std::string_view name, std::span<const double> values) {
  page_numbers(name.data(), name.size(), values.data(), values.size());
}
void tell(std::string_view name, const first_contact::Vector& value) {
  tell(name, std::span(value.data(), 3));
}
void tell(std::string_view name, const char* word) { page_word(name.data(), name.size(), word); }
void tell_whether(std::string_view name, bool is_so) { page_whether(name.data(), name.size(), is_so); }

std::vector<double> given(std::string_view name) {
  std::vector<double> numbers(page_count(name.data(), name.size()));
  page_copy(name.data(), name.size(), numbers.data());
  return numbers;
}

}  // namespace touch
