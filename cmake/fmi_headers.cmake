# FMI_HEADERS_DIR: the folder with fmi2Functions.h. Given by the user, else the one inside the FMPy package of the
# Python interpreter. A plain variable, never cached: under build isolation FMPy lives in a temporary folder.
if(NOT FMI_HEADERS_DIR)
    execute_process(
        COMMAND ${Python3_EXECUTABLE} -X utf8 -c
                "import pathlib, importlib.util as u; print((pathlib.Path(u.find_spec('fmpy').origin).parent / 'c-code').as_posix())"
        OUTPUT_VARIABLE FMI_HEADERS_DIR OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET ENCODING UTF-8)
endif()
if(NOT EXISTS "${FMI_HEADERS_DIR}/fmi2Functions.h")
    message(FATAL_ERROR "fmi2Functions.h was not found. Either install FMPy for ${Python3_EXECUTABLE} "
                        "(python -m pip install fmpy), or pass -DFMI_HEADERS_DIR=<folder of the FMI 2.0 headers>, "
                        "or leave the unit out with -DTDMF_SLIP_BUILD_FMU=OFF.")
endif()
