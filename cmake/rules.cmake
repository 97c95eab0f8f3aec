# What every target of this project is compiled with.

# Warnings are errors here, but not for a project that uses the library as a part of its own.
# Floating-point expressions are rounded as written (no fused multiply-add of the compiler's own choice): printed
# values are reproduced bit for bit, and the derived error bounds hold.
function(house_rules target)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
  endif()
endfunction()
