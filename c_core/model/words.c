/* Conversions of gait words. */
#include "words.h"

#include <math.h>
#include <string.h>

static const char letters[] = "|-0+";
enum { LONGEST_WORD = TDMF_WORD_CAPACITY - 2 };
static const double shortest_long_code = 1073741824.0; /* 4^15 */

static double digit_of(char letter) {
    return (double)(strchr(letters, letter) - letters);
}

double tdmf_code_of_word(const char *word) {
    const size_t length = strcspn(word, "~");
    double code = 0.0;
    for (size_t i = 0; i < length && i < LONGEST_WORD; ++i) {
        code = 4.0 * code + digit_of(word[i]);
    }
    return word[length] == '~' ? -code : code;
}

void tdmf_write_word(double code, char word[TDMF_WORD_CAPACITY]) {
    char reversed[LONGEST_WORD];
    int count = 0, length = 0;
    for (double left = fabs(code); left >= 1.0 && count < LONGEST_WORD; ++count) {
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

double tdmf_last_letter(const char *word) {
    const size_t length = strlen(word);
    return length > 0 && word[length - 1] != '~' ? digit_of(word[length - 1]) : 0.0;
}

int tdmf_short_word_code(double code) {
    return code >= 0.0 && code < shortest_long_code ? (int)code : -1;
}
