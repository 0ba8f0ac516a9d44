/* Reads CPUID, leaves 1 and 7, and the extended control register 0; see Intel's manual, volume 1, chapter 14.
 * The compilers' own __builtin_cpu_supports needs a runtime that not all of them bring along. */
#include "processor.h"

#if defined(TDMF_HAS_AVX2) || defined(TDMF_HAS_AVX512)
#include <cpuid.h>

enum { FMA = 1 << 12, OS_SAVES = 1 << 27 };                    /* leaf 1, ecx */
enum { AVX2 = 1 << 5, AVX512F = 1 << 16, AVX512DQ = 1 << 17 }; /* leaf 7, ebx */
static const unsigned avx512vl = 1u << 31;                     /* leaf 7, ebx */
enum { WIDE_REGISTERS = 0x06, WIDEST_REGISTERS = 0xe6 };       /* control register */

static unsigned leaf_1(void) {
    unsigned eax, ebx, ecx, edx;
    return __get_cpuid(1, &eax, &ebx, &ecx, &edx) ? ecx : 0;
}

static unsigned leaf_7(void) {
    unsigned eax, ebx, ecx, edx;
    return __get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) ? ebx : 0;
}

static bool saves(unsigned registers) {
    unsigned low, high;
    if (!(leaf_1() & OS_SAVES)) {
        return false;
    }
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return (low & registers) == registers;
}

static bool has(unsigned features) {
    return (leaf_7() & features) == features;
}

bool tdmf_processor_has_avx2(void) {
    return saves(WIDE_REGISTERS) && (leaf_1() & FMA) && has(AVX2);
}

bool tdmf_processor_has_avx512(void) {
    return saves(WIDEST_REGISTERS) && has(AVX512F | AVX512DQ | avx512vl);
}
#else
bool tdmf_processor_has_avx2(void) {
    return false;
}

bool tdmf_processor_has_avx512(void) {
    return false;
}
#endif
