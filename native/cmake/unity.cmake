# compile_in_groups(TARGET): files of a folder whose names begin with letters of one range are compiled together, but for kernels.
# A file that is added changes one group.
function(compile_in_groups target)
  get_target_property(files ${target} SOURCES)
  foreach(file ${files})
    if(NOT file MATCHES "/kernels/")
      get_filename_component(folder "${file}" DIRECTORY)
      get_filename_component(folder "${folder}" NAME)
      get_filename_component(name "${file}" NAME)
      foreach(letters a-c d-l m-o p-r s-z)
        if(name MATCHES "^[${letters}]")
          set_source_files_properties("${file}" PROPERTIES UNITY_GROUP ${folder}_${letters})
        endif()
      endforeach()
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Of names of one file that shadow another's; a build of each file judges warnings.
  target_compile_options(${target} PRIVATE -w)
  # GCC collects its garbage when it has 400 MB, which takes a tenth less time.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>)
endfunction()
