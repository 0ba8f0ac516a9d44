# Finds SUNDIALS CVODE 6 as static, position-independent libraries and makes the target CVODE::CVODE. CVODE_ROOT, a
# variable or an environment variable, says where to look first.
set(CVODE_LIBRARIES "")
find_path(CVODE_INCLUDE_DIR cvode/cvode.h)
set(static ${CMAKE_STATIC_LIBRARY_PREFIX})
set(suffix ${CMAKE_STATIC_LIBRARY_SUFFIX})
foreach(part IN ITEMS cvode nvecserial sunlinsoldense sunmatrixdense)
    find_library(CVODE_${part}_LIBRARY ${static}sundials_${part}${suffix})
    mark_as_advanced(CVODE_${part}_LIBRARY)
    list(APPEND CVODE_LIBRARIES ${CVODE_${part}_LIBRARY})
endforeach()
if(CVODE_INCLUDE_DIR)
    file(STRINGS ${CVODE_INCLUDE_DIR}/sundials/sundials_config.h version REGEX "define SUNDIALS_VERSION \"")
    string(REGEX REPLACE ".*\"(.*)\".*" "\\1" CVODE_VERSION "${version}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CVODE
    REQUIRED_VARS CVODE_cvode_LIBRARY CVODE_nvecserial_LIBRARY CVODE_sunlinsoldense_LIBRARY
                  CVODE_sunmatrixdense_LIBRARY CVODE_INCLUDE_DIR
    VERSION_VAR CVODE_VERSION)
if(CVODE_FOUND AND NOT TARGET CVODE::CVODE)
    add_library(CVODE::CVODE INTERFACE IMPORTED)
    set_target_properties(CVODE::CVODE PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES ${CVODE_INCLUDE_DIR}
        INTERFACE_LINK_LIBRARIES "${CVODE_LIBRARIES}")
endif()
