# Files that follow from modelDescription.xml, the one table of variables.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(TDMF_SLIP_VARIABLE_TABLE ${PROJECT_SOURCE_DIR}/modelDescription.xml)
set(TDMF_SLIP_GENERATOR ${PROJECT_SOURCE_DIR}/scripts/generate_variables.py)

# generate_variables(<what> <output> [<argument>...]): see scripts/generate_variables.py --help.
function(generate_variables what output)
    add_custom_command(
        OUTPUT ${output}
        COMMAND Python3::Interpreter ${TDMF_SLIP_GENERATOR} ${what} ${TDMF_SLIP_VARIABLE_TABLE} ${output}
                --version ${PROJECT_VERSION} ${ARGN}
        DEPENDS ${TDMF_SLIP_VARIABLE_TABLE} ${TDMF_SLIP_GENERATOR}
        COMMENT "Generating ${what} from modelDescription.xml" VERBATIM)
endfunction()
