# tdmf_slip_unit_sources(<variable> <object library>...): the C files of a unit, from those of the core that run the
# runner's page and the lists of these libraries. Sets <variable>_files, absolute paths with private headers, and
# <variable>_names, the C files' names. In the unit they lie in one folder, so every name may occur once. SUNDIALS stays
# out: CVODE is refused with a message.
function(tdmf_slip_unit_sources variable)
    set(core ${PROJECT_SOURCE_DIR}/c_core)
    set(files ${core}/derived/pages/runner.c ${core}/derived/pages/runner.h ${core}/derived/pages/runner_motions.c
              ${core}/derived/pages/plain_runner.c ${core}/derived/pages/plain_runner.h
              ${core}/derived/pages/plain_runner_motions.c ${core}/derived/pages/plain_runner_in_runner.c
              ${core}/derived/pages/unit_page.h ${core}/hybrid/kernel/driver.c ${core}/hybrid/kernel/observed.c
              ${core}/hybrid/kernel/page_exchange.c ${core}/hybrid/kernel/page_instant.c ${core}/hybrid/kernel/page_part.c
              ${core}/hybrid/kernel/run_state.c ${core}/hybrid/kernel/no_page_cvode.c)
    set(folders ${core}/kernel ${core}/hybrid/kernel)
    foreach(target IN ITEMS ${ARGN})
        get_target_property(sources ${target} SOURCES)
        get_target_property(folder ${target} SOURCE_DIR)
        foreach(source IN LISTS sources)
            cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder})
            list(APPEND files ${source})
            cmake_path(GET source PARENT_PATH parent)
            if(NOT parent STREQUAL "${core}/derived/pages")
                list(APPEND folders ${parent})
            endif()
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES folders)
    foreach(folder IN LISTS folders)
        cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${folder} is_generated)
        if(NOT is_generated)
            tdmf_slip_glob(headers ${folder} *.h CONFIGURE_DEPENDS)
            list(APPEND files ${headers})
        endif()
    endforeach()
    set(names "")
    set(compiled "")
    foreach(file IN LISTS files)
        cmake_path(GET file FILENAME name)
        if(name IN_LIST names)
            message(FATAL_ERROR "Two files of the unit's sources are called ${name}; give one another name.")
        endif()
        list(APPEND names ${name})
        if(name MATCHES "[.]c$")
            list(APPEND compiled ${name})
        endif()
    endforeach()
    set(${variable}_files ${files} PARENT_SCOPE)
    set(${variable}_names ${compiled} PARENT_SCOPE)
endfunction()
