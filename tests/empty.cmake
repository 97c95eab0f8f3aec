# folder: must hold no file, or not be there at all.
file(GLOB_RECURSE found ${folder}/*)
if(found)
  message(FATAL_ERROR "installed, though the host project did not ask for it: ${found}")
endif()
