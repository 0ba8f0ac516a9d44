/* Gait words of a page: letters as digits in base 4. */
#ifndef TDMF_ENSEMBLE_WORDS_H
#define TDMF_ENSEMBLE_WORDS_H

#include "tdmf_slip/stride.h"

#include <math.h>

/* The code of a stride's word; -1 for a word of more than 15 letters. */
static inline int tdmf_word_code(double code) {
    return code >= 0.0 && code < 1073741824.0 ? (int)code : -1; /* 4^15 */
}

/* The word of a page's code. After the letters that a code holds, "~" stands for those that it does not. */
static inline void tdmf_write_word(double code, char word[TDMF_WORD_CAPACITY]) {
    char reversed[TDMF_WORD_CAPACITY];
    int count = 0, length = 0;
    for (double left = fabs(code); left >= 1.0 && count < TDMF_WORD_CAPACITY - 2; ++count) {
        const double rest = floor(left / 4.0);
        reversed[count] = "|-0+"[(int)(left - 4.0 * rest)];
        left = rest;
    }
    while (count > 0) {
        word[length++] = reversed[--count];
    }
    if (code < 0.0) {
        word[length++] = '~';
    }
    word[length] = '\0';
}

#endif
