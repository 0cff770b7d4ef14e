include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/splinecore)
install(TARGETS splinecore EXPORT splinecoreTargets)
install(DIRECTORY include/splinecore DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT splinecoreTargets NAMESPACE splinecore:: DESTINATION ${package_dir})
configure_file(cmake/splinecore.pc.in ${CMAKE_CURRENT_BINARY_DIR}/splinecore.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/splinecore.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
configure_package_config_file(cmake/splinecoreConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/splinecoreConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/splinecoreConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/splinecoreConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/splinecoreConfigVersion.cmake DESTINATION ${package_dir})
