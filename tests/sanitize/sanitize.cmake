# Instruments everything that is built: SPLINEWRIGHT_SANITIZE is address (with undefined behavior) or thread.
set(SPLINEWRIGHT_SANITIZE "" CACHE STRING "Sanitizer of the whole build: address, thread or none")
option(SPLINEWRIGHT_FUZZ "Build the fuzz targets; with address, and clang" OFF)

if(SPLINEWRIGHT_SANITIZE STREQUAL "address")
  set(flags -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
elseif(SPLINEWRIGHT_SANITIZE STREQUAL "thread")
  set(flags -fsanitize=thread)
elseif(SPLINEWRIGHT_SANITIZE)
  message(FATAL_ERROR "SPLINEWRIGHT_SANITIZE is '${SPLINEWRIGHT_SANITIZE}': address or thread is expected")
elseif(SPLINEWRIGHT_FUZZ)
  message(FATAL_ERROR "SPLINEWRIGHT_FUZZ needs SPLINEWRIGHT_SANITIZE=address")
endif()
if(flags)
  # The standard library's own checks find what stays inside an allocation; no whole-program optimization hides a frame.
  add_compile_options(${flags} -fno-omit-frame-pointer)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(${flags})
  set(CMAKE_INTERPROCEDURAL_OPTIMIZATION OFF)
endif()

# What is watched closely: optimized, for it does the work, and with all its branches told to the fuzz targets. The
# rest is built once and runs for seconds: not to optimize it halves the time of a build.
function(splinewright_watch target)
  if(SPLINEWRIGHT_SANITIZE)
    target_compile_options(${target} PRIVATE -O1 $<$<BOOL:${SPLINEWRIGHT_FUZZ}>:-fsanitize=fuzzer-no-link>)
  endif()
endfunction()
