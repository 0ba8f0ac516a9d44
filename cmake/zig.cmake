# Toolchain: the C cross-compiler of the PyPI package ziglang, which needs nothing else. TDMF_SLIP_TARGET is its name of
# the target (x86_64-linux-gnu.2.17, aarch64-macos.11.0-none); ZIG the program, by default that in the package of
# Python3_EXECUTABLE.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TDMF_SLIP_TARGET ZIG)
if(NOT ZIG)
    if(NOT Python3_EXECUTABLE)
        set(Python3_EXECUTABLE python3)
    endif()
    execute_process(
        COMMAND ${Python3_EXECUTABLE} -X utf8 -c
                "import pathlib, ziglang; print((pathlib.Path(ziglang.__file__).parent / 'zig').as_posix())"
        OUTPUT_VARIABLE ZIG OUTPUT_STRIP_TRAILING_WHITESPACE ENCODING UTF-8)
endif()
if(NOT EXISTS "${ZIG}")
    message(FATAL_ERROR "Zig was not found; install it with: ${Python3_EXECUTABLE} -m pip install 'ziglang==0.17.*'")
endif()
set(ZIG ${ZIG} CACHE FILEPATH "Zig's program")
string(REGEX REPLACE "-.*" "" CMAKE_SYSTEM_PROCESSOR "${TDMF_SLIP_TARGET}")
if(TDMF_SLIP_TARGET MATCHES "-macos")
    set(CMAKE_SYSTEM_NAME Darwin)
elseif(TDMF_SLIP_TARGET MATCHES "-windows")
    set(CMAKE_SYSTEM_NAME Windows)
elseif(TDMF_SLIP_TARGET MATCHES "-wasi")
    set(CMAKE_SYSTEM_NAME Generic)
else()
    set(CMAKE_SYSTEM_NAME Linux)
    set(TDMF_SLIP_MATH_LIBRARY m CACHE STRING "Zig brings it")
endif()
set(CMAKE_C_COMPILER ${ZIG} cc)
# Zig keeps what it has compiled by itself: ccache in front of it would only read each file once more.
set(CMAKE_C_COMPILER_LAUNCHER "" CACHE STRING "None, whatever the environment names")
# Zig compiles the C runtime of a target for each set of these, for a minute each on Windows: so CMake's own tests and
# every program have the same.
set(CMAKE_C_FLAGS_INIT "-target ${TDMF_SLIP_TARGET} -O3 -s")
set(CMAKE_C_ARCHIVE_CREATE "\"${ZIG}\" ar qcs <TARGET> <OBJECTS>")
set(CMAKE_C_ARCHIVE_FINISH "")
# The result must not depend on the machine that builds it.
set(CMAKE_FIND_ROOT_PATH ${CMAKE_CURRENT_LIST_DIR}/none)
foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
    set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
