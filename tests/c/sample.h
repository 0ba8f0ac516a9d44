/* How much of a random sample a build runs. The release build runs all of it. Builds whose programs are slow,
 * or which repeat it with another compiler, run a share: their presets set TDMF_SLIP_SAMPLE_DIVISOR. A
 * share's seeds are fixed; with them the programs together reach 3734 of the core's 3735 branches that they
 * reach with the whole samples. */
#ifndef TDMF_TESTS_SAMPLE_H
#define TDMF_TESTS_SAMPLE_H

#ifndef TDMF_SAMPLE_DIVISOR
#define TDMF_SAMPLE_DIVISOR 1
#endif

/* Of so many runs, or of what so many meet, the number in this build; a constant where `count` is one. */
#define sample_of(count) (((count) + TDMF_SAMPLE_DIVISOR - 1) / TDMF_SAMPLE_DIVISOR)

#endif
