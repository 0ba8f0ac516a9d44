/* Which version of the library this is, and what compiled it. */
#ifndef TDMF_SLIP_VERSION_H
#define TDMF_SLIP_VERSION_H

#ifdef __cplusplus
extern "C" {
#endif

/* The library's version, "major.minor.patch". */
const char *tdmf_version(void);

/* What the library was compiled by and how: "GNU 12.2.0, -O3 -DNDEBUG". */
const char *tdmf_compiler(void);

#ifdef __cplusplus
}
#endif
#endif
