# find_package(FirstContact), or pkg-config first_contact: the library, which needs Eigen, and Highway to link.
include(CMakePackageConfigHelpers)

# Public is what stands in a part's own folder, but for what serves one file of it alone; folders below are the insides.
# What a public header includes is installed with it.
file(GLOB public_headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} first_contact/*.hpp)
foreach(part IN LISTS parts)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} first_contact/${part}/*.hpp)
  list(APPEND public_headers ${headers})
endforeach()
set(insides_of_mesh_io flat_polygon mesh_bytes mesh_formats orientation ply_header polygons text_lines)
list(JOIN insides_of_mesh_io "|" insides_of_mesh_io)
list(FILTER public_headers EXCLUDE REGEX "/(mesh_io/(${insides_of_mesh_io})|batch/(desk|loops))\\.hpp$")
set(to_read ${public_headers})
while(to_read)
  list(POP_FRONT to_read header)
  file(STRINGS ${header} includes REGEX "^#include \"first_contact/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${include}")
    if(NOT included IN_LIST public_headers)
      list(APPEND public_headers ${included})
      list(APPEND to_read ${included})
    endif()
  endforeach()
endwhile()

install(TARGETS first_contact_geometry EXPORT FirstContactTargets
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(header IN LISTS public_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/FirstContact)
set(described ${CMAKE_CURRENT_BINARY_DIR})
install(EXPORT FirstContactTargets NAMESPACE FirstContact:: DESTINATION ${package_folder})
configure_package_config_file(FirstContactConfig.cmake.in ${described}/FirstContactConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
configure_file(FirstContactConfigVersion.cmake.in ${described}/FirstContactConfigVersion.cmake @ONLY)
install(FILES ${described}/FirstContactConfig.cmake ${described}/FirstContactConfigVersion.cmake
        DESTINATION ${package_folder})

# For pkg-config: where the library is relative to this file, and every definition that its users must have too.
get_target_property(definitions first_contact_geometry INTERFACE_COMPILE_DEFINITIONS)
string(REGEX REPLACE "(^|;)([^;]+)" " -D\\2" definitions "${definitions}")
string(REPLACE " -Ddefinitions-NOTFOUND" "" definitions "${definitions}")
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE library_folder)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE up_to_prefix)
configure_file(first_contact.pc.in ${described}/first_contact.pc @ONLY)
install(FILES ${described}/first_contact.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
