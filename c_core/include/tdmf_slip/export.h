/* Exports of the shared library: functions that are marked with TDMF_API, and no other name. */
#ifndef TDMF_SLIP_EXPORT_H
#define TDMF_SLIP_EXPORT_H

/* TDMF_BUILDS_SHARED_LIBRARY is defined where tdmf_slip_shared itself is compiled. The static libraries and
 * the unit export nothing, and a program that links one of the libraries defines nothing. */
#if !defined(TDMF_BUILDS_SHARED_LIBRARY)
#define TDMF_API
#elif defined(_WIN32)
#define TDMF_API __declspec(dllexport)
#else
#define TDMF_API __attribute__((visibility("default")))
#endif

#endif
