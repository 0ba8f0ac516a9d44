/* Conversions of gait words. */
#include "words.h"

#include <math.h>
#include <string.h>

static const char letters[] = "|-0+";
enum { LONGEST_WORD = TDMF_WORD_CAPACITY - 2 };
static const double shortest_long_code = 1073741824.0; /* 4^15 */

void tdmf_write_word(double code, char word[TDMF_WORD_CAPACITY]) {
    char reversed[LONGEST_WORD];
    int count = 0, length = 0;
    for (double left = isfinite(code) ? fabs(code) : 0.0; left >= 1.0 && count < LONGEST_WORD; ++count) {
        const double rest = floor(left / 4.0);
        reversed[count] = letters[(int)(left - 4.0 * rest)];
        left = rest;
    }
    memset(word, 0, TDMF_WORD_CAPACITY);
    while (count > 0) {
        word[length++] = reversed[--count];
    }
    if (code < 0.0) {
        word[length] = '~';
    }
}

int tdmf_short_word_code(double code) {
    return code >= 0.0 && code < shortest_long_code ? (int)code : -1;
}
