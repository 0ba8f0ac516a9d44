# Installation: the libraries, and the component unit, which only the Python package asks for by its name.
# In the Python package it is one file, whose name has no version.
set(file_name $<TARGET_FILE_PREFIX:tdmf_slip_shared>$<TARGET_FILE_BASE_NAME:tdmf_slip_shared>$<TARGET_FILE_SUFFIX:tdmf_slip_shared>)
install(PROGRAMS $<TARGET_FILE:tdmf_slip_shared> DESTINATION tdmf_slip/native RENAME ${file_name}
        COMPONENT unit EXCLUDE_FROM_ALL)
install(DIRECTORY include/tdmf_slip DESTINATION tdmf_slip/native COMPONENT unit EXCLUDE_FROM_ALL)
# With these and the kernel, the package builds libraries of its users' pages.
install(FILES gait/page.c gait/page_batch.c gait/page_map.h DESTINATION tdmf_slip/gait COMPONENT unit EXCLUDE_FROM_ALL)
set(engine affine_law.c drawn_ground.c drawn_ground.h ensemble.c ground.c ground.h ground_checks.c member.c member.h normal_deviates.c page_member.c philox.c philox.h request_checks.c
    request_checks.h settled.c settled.h)
list(TRANSFORM engine PREPEND ensemble/)
install(FILES ${engine} model/refusal.c model/refusal.h solver/stride_limits.h DESTINATION tdmf_slip/ensemble COMPONENT unit EXCLUDE_FROM_ALL)
install(FILES ${declarations} DESTINATION tdmf_slip/library COMPONENT unit EXCLUDE_FROM_ALL)
install(FILES derived/unit/data.py derived/unit/classic_slip.json derived/unit/runner.json DESTINATION tdmf_slip/variables COMPONENT unit EXCLUDE_FROM_ALL)

include(CMakePackageConfigHelpers)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/tdmf_slip)
install(TARGETS tdmf_slip tdmf_slip_ensemble tdmf_slip_shared EXPORT tdmf_slip COMPONENT library)
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(EXPORT tdmf_slip FILE tdmf_slipConfig.cmake NAMESPACE tdmf_slip:: DESTINATION ${package_directory}
        COMPONENT library)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/tdmf_slipConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tdmf_slipConfigVersion.cmake DESTINATION ${package_directory}
        COMPONENT library)
# A package that pkg-config finds may have been moved since it was configured, as by cmake --install --prefix, unless a
# folder was given as an absolute path.
string(REPLACE " " "\\ " prefix_of_pc ${CMAKE_INSTALL_PREFIX})
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
    file(RELATIVE_PATH prefix_of_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
    string(PREPEND prefix_of_pc "\${pcfiledir}/")
endif()
foreach(folder IN ITEMS LIBDIR INCLUDEDIR)
    string(REPLACE " " "\\ " ${folder}_of_pc ${CMAKE_INSTALL_${folder}})
    if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_${folder}}")
        string(PREPEND ${folder}_of_pc "\${prefix}/")
    endif()
endforeach()
foreach(library IN ITEMS tdmf_slip tdmf_slip_ensemble)
    configure_file(${library}.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${library}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
            COMPONENT library)
endforeach()
