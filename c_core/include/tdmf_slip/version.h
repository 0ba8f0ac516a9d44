/* Version of the library, and the compiler that built it. */
#ifndef TDMF_SLIP_VERSION_H
#define TDMF_SLIP_VERSION_H

#include "tdmf_slip/export.h"

/* The version that a program is compiled with; whatever else has a version reads these numbers. While the
 * first is 0, another second number may mean another interface. */
#define TDMF_VERSION_MAJOR 0
#define TDMF_VERSION_MINOR 1
#define TDMF_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the library that is running, "major.minor.patch". */
TDMF_API const char *tdmf_version(void);

/* Compiler of the library and its options: "GNU 12.2.0, -O3 -DNDEBUG". */
TDMF_API const char *tdmf_compiler(void);

#ifdef __cplusplus
}
#endif
#endif
