/* Why the library refused a value: which one, where it stands, and what is allowed. */
#ifndef TDMF_SLIP_REFUSAL_H
#define TDMF_SLIP_REFUSAL_H

#include "tdmf_slip/export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The kind of a refusal. */
typedef enum {
    TDMF_ACCEPTED,     /* nothing was refused */
    TDMF_OUT_OF_RANGE, /* a number is beyond its limits, or NaN */
    TDMF_IS_NULL,      /* a pointer is NULL that must not be */
    TDMF_EXCLUDED,     /* a value excludes another one; `bound_by` says which and why */
    TDMF_UNAVAILABLE   /* memory is short, or the build or the processor lacks something */
} tdmf_refusal_code;

/* A refusal. All strings are static. */
typedef struct {
    tdmf_refusal_code code; /* kind of the refusal */
    const char *variable;   /* name of the variable in the FMU, "leg.length", or of the argument,
                               "solver.log.count"; NULL if nothing was refused */
    int64_t index;          /* the element's number, from 0, if the name has a "[]"; else 0 */
    const char *unit;       /* unit of value and limits; NULL if the value is no number */
    double value;           /* the number given */
    double minimum;         /* smallest number allowed */
    double maximum;         /* largest number allowed */
    const char *bound_by;   /* the variable or rule that sets the limit, or NULL */
} tdmf_refusal;

/* Writes a sentence such as "leg.length = 0.01 m is refused: allowed from 0.05 (leg.min_length) to 1e+09 m"
 * into `text`, with a decimal point whatever the locale. The text is cut to `capacity` and always terminated.
 * Returns `text`. If it is NULL, nothing is written.
 *
 *     char text[256];
 *     const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
 *     if (refusal.code != TDMF_ACCEPTED)
 *         fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
 */
TDMF_API char *tdmf_refusal_text(const tdmf_refusal *refusal, char *text, size_t capacity);

#ifdef __cplusplus
}
#endif
#endif
