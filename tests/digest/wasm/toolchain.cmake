# WebAssembly by clang, with the C and C++ libraries of Debian's wasi-libc and libc++-dev-wasm32.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT "-O2 -isystem \"${CMAKE_CURRENT_LIST_DIR}\"")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=8388608")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
