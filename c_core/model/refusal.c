/* Refusals, and the sentences about them. */
#include "refusal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool tdmf_accepts(tdmf_refusal *why, tdmf_refusal refusal) {
    if (refusal.variable != NULL) {
        *why = refusal;
    }
    return refusal.variable == NULL;
}

tdmf_refusal tdmf_absent(const char *name) {
    const tdmf_refusal refusal = {.code = TDMF_IS_NULL, .variable = name, .value = (double)NAN};
    return refusal;
}

static bool accepts(tdmf_refusal *why, const tdmf_refusal *number) {
    const bool is_in_range = number->value >= number->minimum && number->value <= number->maximum;
    if (!is_in_range) {
        *why = *number;
    }
    return is_in_range;
}

bool tdmf_accepts_number(tdmf_refusal *why, const char *name, const char *unit, double value, double minimum,
                         double maximum) {
    const tdmf_refusal number = {.code = TDMF_OUT_OF_RANGE,
                                 .variable = name,
                                 .unit = unit,
                                 .value = value,
                                 .minimum = minimum,
                                 .maximum = maximum};
    return accepts(why, &number);
}

bool tdmf_accepts_element(tdmf_refusal *why, const char *name, int64_t index, double value, double minimum,
                          double maximum) {
    const bool is_accepted = tdmf_accepts_number(why, name, "1", value, minimum, maximum);
    if (!is_accepted) {
        why->index = index;
    }
    return is_accepted;
}

bool tdmf_accepts_array(tdmf_refusal *why, const char *name, const void *elements, const char *count_name,
                        int64_t count, int64_t most) {
    return tdmf_accepts_number(why, count_name, "1", (double)count, 0.0, (double)most) &&
           (count == 0 || tdmf_accepts_pointer(why, name, elements));
}

bool tdmf_accepts_if(tdmf_refusal *why, bool holds, tdmf_refusal_code code, const char *name, int64_t index,
                     const char *rule) {
    if (!holds) {
        const tdmf_refusal refusal = {
            .code = code, .variable = name, .index = index, .value = (double)NAN, .bound_by = rule};
        *why = refusal;
    }
    return holds;
}

/* printf takes the decimal separator from the locale; a message, like a file, should not. */
static const char *number(double value, char text[32]) {
    snprintf(text, 32, "%.9g", value);
    for (char *c = text; *c != '\0'; ++c) {
        if (*c == ',') {
            *c = '.';
        }
    }
    return text;
}

/* The variable's name, with the element's number in its brackets. */
static const char *place(const tdmf_refusal *refusal, char text[96]) {
    const char *brackets = strstr(refusal->variable, "[]");
    if (brackets == NULL) {
        return refusal->variable;
    }
    snprintf(text, 96, "%.*s[%lld%s", (int)(brackets - refusal->variable), refusal->variable,
             (long long)refusal->index, brackets + 1);
    return text;
}

char *tdmf_refusal_text(const tdmf_refusal *refusal, char *text, size_t capacity) {
    char value[32], minimum[32], maximum[32], name[96];
    if (text == NULL || capacity == 0) {
        return text;
    }
    if (refusal->variable == NULL) {
        snprintf(text, capacity, "accepted");
        return text;
    }
    const char *rule = refusal->bound_by;
    if (refusal->code != TDMF_OUT_OF_RANGE) {
        const char *is_refused = refusal->code == TDMF_UNAVAILABLE ? "" : " is refused";
        snprintf(text, capacity, "%s%s: %s", place(refusal, name), is_refused, rule ? rule : "it is NULL");
        return text;
    }
    const bool has_unit = refusal->unit != NULL && strcmp(refusal->unit, "1") != 0;
    const char *space = has_unit ? " " : "", *unit = has_unit ? refusal->unit : "";
    snprintf(text, capacity, "%s = %s%s%s is refused: allowed from %s to %s%s%s%s%s%s", place(refusal, name),
             number(refusal->value, value), space, unit, number(refusal->minimum, minimum),
             number(refusal->maximum, maximum), space, unit, rule ? " (" : "", rule ? rule : "",
             rule ? ")" : "");
    return text;
}
