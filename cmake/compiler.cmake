# Hardening, where compiler and platform have it: stacks are checked, a frame of more than a page is opened page by page,
# so that none is skipped over, jumps arrive at marked places only (on Intel and on Arm, where return addresses are signed
# too), and calls of the C library that write where the size is known are checked; in ELF files the loader binds all
# symbols at once and then makes their table read-only. MSVC checks stacks by itself, Windows opens frames page by page
# in any case, Windows and macOS have no such table; the C library of MinGW checks nothing.
include(CheckCCompilerFlag)
include(CheckLinkerFlag)
set(hardening_flags -fstack-protector-strong -fstack-clash-protection -fcf-protection -mbranch-protection=standard)
if(NOT MSVC)
    set(CMAKE_REQUIRED_FLAGS -Werror) # what a platform does without is told by a warning
    foreach(flag IN LISTS hardening_flags)
        string(MAKE_C_IDENTIFIER "TDMF_SLIP_COMPILER_TAKES${flag}" takes)
        check_c_compiler_flag(${flag} ${takes})
        if(${takes})
            list(APPEND TDMF_SLIP_HARDENING ${flag})
        endif()
    endforeach()
    unset(CMAKE_REQUIRED_FLAGS)
endif()
set(bind_at_once LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
if(NOT WIN32 AND NOT APPLE)
    check_linker_flag(C "${bind_at_once}" TDMF_SLIP_LINKER_BINDS_AT_ONCE)
endif()
function(tdmf_slip_harden target)
    target_compile_options(${target} PRIVATE ${TDMF_SLIP_HARDENING})
    if(NOT WIN32 AND NOT TDMF_SLIP_SANITIZE) # sanitizers check more
        target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>)
    endif()
    if(TDMF_SLIP_LINKER_BINDS_AT_ONCE)
        target_link_options(${target} PRIVATE ${bind_at_once})
    endif()
endfunction()

# Warnings, floating point and hardening, for every target of ours. Static functions of two files may have the same name,
# so that files are never compiled together.
function(tdmf_slip_compile target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise $<$<BOOL:${TDMF_SLIP_WARNINGS_ARE_ERRORS}>:/WX>)
        target_compile_definitions(${target} PRIVATE _CRT_SECURE_NO_WARNINGS)
        return()
    endif()
    # Contraction into fused multiply-adds would make results depend on the processor.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off -fno-math-errno
                           $<$<BOOL:${TDMF_SLIP_WARNINGS_ARE_ERRORS}>:-Werror>)
    tdmf_slip_harden(${target})
    if(TDMF_SLIP_SANITIZE)
        set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
            $<$<BOOL:${TDMF_SLIP_FUZZ}>:-fsanitize=fuzzer-no-link>)
        target_compile_options(${target} PRIVATE ${sanitizers})
        target_link_options(${target} PRIVATE ${sanitizers})
    endif()
endfunction()
