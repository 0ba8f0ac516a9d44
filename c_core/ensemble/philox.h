/* Random numbers by a counter. */
#ifndef TDMF_ENSEMBLE_PHILOX_H
#define TDMF_ENSEMBLE_PHILOX_H

#include <stdint.h>

/* Philox4x32-10: four words that look random, of a counter and a key. J. K. Salmon et al., "Parallel random
 * numbers: as easy as 1, 2, 3", Proc. SC11 (2011). Whole numbers only, so that they are the same everywhere.
 */
void tdmf_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t words[4]);

#endif
