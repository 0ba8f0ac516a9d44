/* Checks that say why: each returns true if it accepts, else it writes the refusal into `why` and returns
 * false. They are joined by &&, so that `why` has the first refusal. */
#ifndef TDMF_MODEL_REFUSAL_H
#define TDMF_MODEL_REFUSAL_H

#include "tdmf_slip/refusal.h"

#include <stdbool.h>
#include <stddef.h>

/* A refusal that another function has found. */
bool tdmf_accepts(tdmf_refusal *why, tdmf_refusal refusal);

/* Refuses a pointer that is NULL. */
tdmf_refusal tdmf_absent(const char *name);

/* Stands here so that the static analyzer sees that an accepted pointer is not NULL. */
static inline bool tdmf_accepts_pointer(tdmf_refusal *why, const char *name, const void *pointer) {
    if (pointer == NULL) {
        *why = tdmf_absent(name);
    }
    return pointer != NULL;
}

/* Accepts a number from `minimum` to `maximum`, but not NaN. */
bool tdmf_accepts_number(tdmf_refusal *why, const char *name, const char *unit, double value, double minimum,
                         double maximum);

/* An element of an array. */
bool tdmf_accepts_element(tdmf_refusal *why, const char *name, int64_t index, double value, double minimum,
                          double maximum);

/* Accepts a count from 0 on, and its array, which may be NULL if it has no elements. */
bool tdmf_accepts_array(tdmf_refusal *why, const char *name, const void *elements, const char *count_name,
                        int64_t count, int64_t most);

/* Accepts if `holds`; otherwise writes the refusal of the element `index` of `name` by `rule`. */
bool tdmf_accepts_if(tdmf_refusal *why, bool holds, tdmf_refusal_code code, const char *name, int64_t index,
                     const char *rule);

#endif
