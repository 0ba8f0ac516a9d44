/* Gait words by their codes on the runner's page: letters are digits in base 4. The code of a word that has
 * been cut is negative. */
#ifndef TDMF_MODEL_WORDS_H
#define TDMF_MODEL_WORDS_H

#include "tdmf_slip/stride.h"

void tdmf_write_word(double code, char word[TDMF_WORD_CAPACITY]);

/* The code as in tdmf_stride: -1 for a word of more than 15 letters, two bits each in a 32-bit Integer. */
int tdmf_short_word_code(double code);

#endif
