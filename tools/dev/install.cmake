# Installs the programs (geminga_program), the ontologies, the public face and the C++ client as the CMake package Geminga:
# find_package(Geminga) gives Geminga::client; the C library is Geminga::c, and geminga for pkg-config.
include(CMakePackageConfigHelpers)

if(NOT TARGET geminga_client_cpp)
  return()
endif()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME libgeminga-dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/geminga DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(module IN LISTS geminga_client_modules)
  string(REPLACE "/" "_" module ${module})
  install(TARGETS geminga_${module} EXPORT GemingaTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set_target_properties(geminga_${module} PROPERTIES EXPORT_NAME ${module})
endforeach()
set_target_properties(geminga_client_cpp PROPERTIES EXPORT_NAME client)
# The public headers (include/geminga) are C++20, whatever the library was compiled as.
target_compile_features(geminga_client_cpp INTERFACE cxx_std_20)
install(TARGETS geminga EXPORT GemingaTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libgeminga1 NAMELINK_COMPONENT libgeminga-dev)
# Wherever the folder is moved to, cmake --install --prefix included.
file(RELATIVE_PATH geminga_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${PROJECT_SOURCE_DIR}/src/client/c/geminga.pc.in ${PROJECT_BINARY_DIR}/geminga.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/geminga.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Geminga)
install(EXPORT GemingaTargets NAMESPACE Geminga:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/GemingaConfig.cmake.in ${PROJECT_BINARY_DIR}/GemingaConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GemingaConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/GemingaConfig.cmake ${PROJECT_BINARY_DIR}/GemingaConfigVersion.cmake
        DESTINATION ${package_folder})
