/* The exact derivatives of the reduced map against differences in extended precision. */
#ifndef TDMF_TESTS_CHECK_REDUCED_MAP_H
#define TDMF_TESTS_CHECK_REDUCED_MAP_H

/* Returns how many gaits they are wrong at. */
int check_reduced_map(void);

#endif
