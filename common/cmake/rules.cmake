# What every target of this project is compiled with.

# Warnings are told to all who build the course, and are errors for those who develop it, never for those who learn from
# it or who use the library as a part of a project of their own.
option(FIRST_CONTACT_WERROR "Warnings are errors" OFF)

# What g++ 12 to 14 warn of inside their own std::string and std::vector, where they inline much: sound code.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(false_alarms -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
endif()

# Floating-point expressions are rounded as written (no fused multiply-add of the compiler's own choice): printed
# values are reproduced bit for bit, and the derived error bounds hold.
function(house_rules target)
  if(MSVC)
    target_compile_options(${target} PRIVATE /fp:precise /utf-8 /bigobj /permissive-
                           $<$<CXX_COMPILER_ID:Clang>:/clang:-ffp-contract=off>)
  else()
    target_compile_options(${target} PRIVATE -ffp-contract=off)
  endif()
  if(PROJECT_IS_TOP_LEVEL AND MSVC)
    target_compile_options(${target} PRIVATE /W4)
  elseif(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion ${false_alarms})
  endif()
  if(NOT PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND NOT MSVC
     AND NOT CMAKE_CXX_FLAGS MATCHES "-O")
    target_compile_options(${target} PRIVATE -O2)  # a project that asks for no kind of build does not ask for a slow one
  endif()
  set_target_properties(${target} PROPERTIES COMPILE_WARNING_AS_ERROR ${FIRST_CONTACT_WERROR})
endfunction()

# Headers that take long to read are read once for all targets that are compiled alike: together they take half the time.
# `name` is a target that holds them; the others share it by target_precompile_headers(... REUSE_FROM name).
function(read_headers_once name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LINK")
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "// Holds precompiled headers.\n")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE ${arg_LINK})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  house_rules(${name})
endfunction()

# ... and so does every target that uses Eigen, where they are held.
function(share_common_headers target)
  if(TARGET common_headers)
    target_precompile_headers(${target} REUSE_FROM common_headers)
  endif()
endfunction()
