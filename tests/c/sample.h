/* Share of a random sample that a build runs. The release build runs all of it, or a tenth where scripts/test
 * runs without --release. Builds whose programs are slow, or which repeat them with another compiler, run the
 * share that TDMF_SLIP_SAMPLE_DIVISOR of their preset sets. The seeds of a share are fixed. */
#ifndef TDMF_TESTS_SAMPLE_H
#define TDMF_TESTS_SAMPLE_H

#ifndef TDMF_SAMPLE_DIVISOR
#define TDMF_SAMPLE_DIVISOR 1
#endif

/* Number that remains in this build of `count` runs or cases; a constant expression if `count` is one. */
#define sample_of(count) (((count) + TDMF_SAMPLE_DIVISOR - 1) / TDMF_SAMPLE_DIVISOR)

#endif
