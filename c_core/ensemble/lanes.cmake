# The ensemble engine: a library beside the core, because it needs threads and the core needs libm only. Files that step
# runners side by side are compiled once for each instruction set; which one runs is chosen at run time.
include(CheckCCompilerFlag)
find_package(Threads REQUIRED)

set(ensemble_sources ensemble/affine_law.c ensemble/drawn_ground.c ensemble/ensemble.c ensemble/ground.c
    ensemble/ground_checks.c ensemble/member.c ensemble/normal_deviates.c ensemble/page_member.c ensemble/philox.c
    ensemble/request_checks.c ensemble/runner_member.c ensemble/runner_pages.c ensemble/settled.c ensemble/stride_batch.c
    gait/page_batch.c hybrid/kernel/batch.c kernel/processor.c kernel/threads.c)
list(TRANSFORM ensemble_sources PREPEND ${PROJECT_SOURCE_DIR}/c_core/)
set(ensemble_folders include derived/pages model solver kernel gait hybrid/kernel runner)
list(TRANSFORM ensemble_folders PREPEND ${PROJECT_SOURCE_DIR}/c_core/)

# tdmf_slip_add_lanes(<name> <number of lanes> <flag>...): what steps so many runners side by side, if the compiler takes
# the flags.
function(tdmf_slip_add_lanes name count)
    string(MAKE_C_IDENTIFIER "TDMF_SLIP_COMPILER_TAKES_flags_of_${name}" takes)
    string(REPLACE ";" " " flags "${ARGN}")
    check_c_compiler_flag("${flags}" ${takes})
    if(NOT ${takes})
        return()
    endif()
    add_library(tdmf_slip_lanes_${name} OBJECT hybrid/kernel/batch_lanes.c derived/pages/plain_runner_motions.c
                derived/pages/plain_reduced_runner_motions.c derived/pages/reduced_runner_motions.c
                derived/pages/runner_motions.c)
    target_include_directories(tdmf_slip_lanes_${name} PRIVATE ${ensemble_folders})
    target_compile_definitions(tdmf_slip_lanes_${name} PRIVATE TDMF_LANES=${count})
    tdmf_slip_compile(tdmf_slip_lanes_${name})
    target_compile_options(tdmf_slip_lanes_${name} PRIVATE ${ARGN})
    if(TDMF_SLIP_SANITIZE AND count GREATER 2) # two lanes check the same arithmetic, for half the time of the compiler
        target_compile_options(tdmf_slip_lanes_${name} PRIVATE -fno-sanitize=undefined -fsanitize=bounds,alignment)
    endif()
    string(TOUPPER TDMF_HAS_${name} macro)
    set_property(DIRECTORY APPEND PROPERTY lanes $<TARGET_OBJECTS:tdmf_slip_lanes_${name}>)
    set_property(DIRECTORY APPEND PROPERTY lane_macros ${macro})
endfunction()

# Vector types are an extension of GCC and clang. GCC for Windows does not align wide vectors on the stack. No product is
# contracted with a sum: so all numbers of lanes give the same bits.
if(CMAKE_C_COMPILER_ID MATCHES "^(GNU|Clang|AppleClang)$" AND NOT CMAKE_C_SIMULATE_ID STREQUAL "MSVC"
   AND NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
    tdmf_slip_add_lanes(two_lanes 2 -ffp-contract=off)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND NOT (WIN32 AND CMAKE_C_COMPILER_ID STREQUAL "GNU")
       AND (NOT TDMF_SLIP_SANITIZE OR TDMF_SLIP_SANITIZE_WIDE_LANES))
        tdmf_slip_add_lanes(avx2 4 -mavx2 -ffp-contract=off)
        tdmf_slip_add_lanes(avx512 8 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512 -ffp-contract=off)
    endif()
endif()
get_property(lanes DIRECTORY PROPERTY lanes)
get_property(lane_macros DIRECTORY PROPERTY lane_macros)

# tdmf_slip_use_ensemble(<target>): puts the engine into a library of the core's sources, or beside one.
function(tdmf_slip_use_ensemble target)
    target_sources(${target} PRIVATE ${ensemble_sources} ${lanes})
    target_include_directories(${target} PRIVATE ${ensemble_folders})
    target_compile_definitions(${target} PRIVATE ${lane_macros})
    target_link_libraries(${target} PRIVATE ${CMAKE_THREAD_LIBS_INIT})
endfunction()
