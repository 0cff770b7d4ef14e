# Zig's linker for Macs does not make bundles; Python loads a shared library as well.
if(CMAKE_SYSTEM_NAME STREQUAL Darwin)
  set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS "-shared")
endif()
