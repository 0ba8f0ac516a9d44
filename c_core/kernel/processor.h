/* Which instructions the processor has, and the operating system saves registers for. */
#ifndef TDMF_KERNEL_PROCESSOR_H
#define TDMF_KERNEL_PROCESSOR_H

#include <stdbool.h>

bool tdmf_processor_has_avx2(void);   /* and fused multiply-add */
bool tdmf_processor_has_avx512(void); /* F, DQ and VL */

#endif
