# find_package(FirstContact) gives FirstContact::geometry, which needs Eigen, and Highway to link.
include(CMakePackageConfigHelpers)

install(TARGETS first_contact_geometry EXPORT FirstContactTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(part geometry mesh_io sweep trees bvh batch pairs response motion stage)
  install(DIRECTORY first_contact/${part} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/first_contact
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/FirstContact)
install(EXPORT FirstContactTargets NAMESPACE FirstContact:: DESTINATION ${package_folder})
configure_package_config_file(FirstContactConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/FirstContactConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/FirstContactConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/FirstContactConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/FirstContactConfigVersion.cmake
        DESTINATION ${package_folder})
