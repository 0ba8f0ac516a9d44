/* Number of elements of an array. */
#ifndef TDMF_TESTS_COUNT_OF_H
#define TDMF_TESTS_COUNT_OF_H

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

#endif
