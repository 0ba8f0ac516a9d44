# Warnings and floating point, for every target of ours.
function(tdmf_slip_compile target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise $<$<BOOL:${TDMF_SLIP_WARNINGS_ARE_ERRORS}>:/WX>)
        target_compile_definitions(${target} PRIVATE _CRT_SECURE_NO_WARNINGS)
        return()
    endif()
    # Contraction into fused multiply-adds would make results depend on the processor.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off -fno-math-errno
                           $<$<BOOL:${TDMF_SLIP_WARNINGS_ARE_ERRORS}>:-Werror>)
    if(TDMF_SLIP_SANITIZE)
        set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
            $<$<BOOL:${TDMF_SLIP_FUZZ}>:-fsanitize=fuzzer-no-link>)
        target_compile_options(${target} PRIVATE ${sanitizers})
        target_link_options(${target} PRIVATE ${sanitizers})
    endif()
endfunction()
