# Files that follow from modelDescription.xml, the one table of variables.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(TDMF_SLIP_VARIABLE_TABLE ${PROJECT_SOURCE_DIR}/modelDescription.xml)
set(TDMF_SLIP_GENERATOR ${PROJECT_SOURCE_DIR}/scripts/generate_variables.py)

# tdmf_slip_generate(<what> <output> [TEMPLATE <file>] [<argument>...]): see scripts/generate_variables.py --help.
function(tdmf_slip_generate what output)
    cmake_parse_arguments(given "" TEMPLATE "" ${ARGN})
    set(template ${given_TEMPLATE})
    list(TRANSFORM template PREPEND "--template=")
    add_custom_command(
        OUTPUT ${output}
        COMMAND Python3::Interpreter ${TDMF_SLIP_GENERATOR} ${what} ${TDMF_SLIP_VARIABLE_TABLE} ${output}
                --version ${PROJECT_VERSION} ${template} ${given_UNPARSED_ARGUMENTS}
        DEPENDS ${TDMF_SLIP_VARIABLE_TABLE} ${TDMF_SLIP_GENERATOR} ${PROJECT_SOURCE_DIR}/c_core/hybrid/description.py
                ${given_TEMPLATE}
        COMMENT "Generating ${what} from modelDescription.xml" VERBATIM)
endfunction()
