# FMI's names of platforms, fmi2_platform (linux64) and fmi3_platform (x86_64-linux), and
# tdmf_slip_fmu_library(<target> <folder>): how a unit's shared library is called and linked.
math(EXPR bits "8 * ${CMAKE_SIZEOF_VOID_P}")
set(processors "AMD64=x86_64" "arm64=aarch64" "ARM64=aarch64")
set(processor ${CMAKE_SYSTEM_PROCESSOR})
foreach(pair IN LISTS processors)
    string(REGEX REPLACE "^([^=]+)=.*" "\\1" theirs ${pair})
    string(REGEX REPLACE "^[^=]+=" "" ours ${pair})
    if(processor STREQUAL theirs)
        set(processor ${ours})
    endif()
endforeach()
if(WIN32)
    set(fmi2_platform win${bits})
    set(fmi3_platform ${processor}-windows)
elseif(APPLE)
    set(fmi2_platform darwin${bits})
    set(fmi3_platform ${processor}-darwin)
else()
    set(fmi2_platform linux${bits})
    set(fmi3_platform ${processor}-linux)
endif()

# Where the linker can, it keeps the symbols of static libraries inside, whatever the importer has loaded beside it;
# those of this project are hidden anyway.
include(CheckLinkerFlag)
check_linker_flag(C -Wl,--exclude-libs,ALL TDMF_SLIP_LINKER_EXCLUDES_LIBRARIES)

function(tdmf_slip_fmu_library target folder)
    set_target_properties(${target} PROPERTIES
        PREFIX "" OUTPUT_NAME TDMF_SLIP SUFFIX ${CMAKE_SHARED_LIBRARY_SUFFIX}
        ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/import/${target}
        LIBRARY_OUTPUT_DIRECTORY $<1:${folder}>
        RUNTIME_OUTPUT_DIRECTORY $<1:${folder}>)
    if(APPLE)
        set_target_properties(${target} PROPERTIES SUFFIX .dylib NO_SONAME ON)
        target_link_options(${target} PRIVATE -Wl,-install_name,@rpath/TDMF_SLIP.dylib)
    elseif(TDMF_SLIP_LINKER_EXCLUDES_LIBRARIES)
        target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
    endif()
endfunction()
