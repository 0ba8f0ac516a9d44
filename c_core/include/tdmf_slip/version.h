#ifndef TDMF_SLIP_VERSION_H
#define TDMF_SLIP_VERSION_H

#ifdef __cplusplus
extern "C" {
#endif

/* The library's version, "major.minor.patch". */
const char *tdmf_version(void);

#ifdef __cplusplus
}
#endif
#endif
