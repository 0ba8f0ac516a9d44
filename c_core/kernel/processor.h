/* Instructions that the processor has and whose registers the operating system saves. */
#ifndef TDMF_KERNEL_PROCESSOR_H
#define TDMF_KERNEL_PROCESSOR_H

#include <stdbool.h>

bool tdmf_processor_has_avx2(void);   /* with fused multiply-add */
bool tdmf_processor_has_avx512(void); /* F, DQ and VL */

#endif
