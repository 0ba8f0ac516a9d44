/* The table of variables as the core needs it: ranges and start values. Its rows are derived
 * from c_core/pages, in the order declared here. */
#ifndef TDMF_MODEL_RANGES_H
#define TDMF_MODEL_RANGES_H

#include "refusal.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#include <stdbool.h>

typedef struct {
    const char *name;
    const char *unit;
    double minimum;
    double maximum;
    double start;
    bool continuous; /* may change between events */
    bool at_events;  /* may change at events */
    int place;       /* number on the runner's page: of a parameter, or of a state counted on from there */
    size_t offset;   /* offset of the value in tdmf_parameters or tdmf_inputs; not used for states */
} tdmf_range;

/* A Boolean parameter. */
typedef struct {
    const char *name;
    bool start;
    size_t offset; /* offset in tdmf_parameters */
} tdmf_flag;

extern const tdmf_range tdmf_parameter_ranges[TDMF_PARAMETER_COUNT];
extern const tdmf_flag tdmf_parameter_flags[];
extern const size_t tdmf_parameter_flag_count;
extern const tdmf_range tdmf_input_ranges[TDMF_INPUT_COUNT];
extern const tdmf_range tdmf_state_ranges[TDMF_MECHANICAL_COUNT];

/* NaN is in no range. */
static inline bool tdmf_in_range(const tdmf_range *range, double value) {
    return value >= range->minimum && value <= range->maximum;
}

static inline tdmf_refusal tdmf_out_of_range(const tdmf_range *range, double value) {
    const tdmf_refusal refusal = {.code = TDMF_OUT_OF_RANGE,
                                  .variable = range->name,
                                  .unit = range->unit,
                                  .value = value,
                                  .minimum = range->minimum,
                                  .maximum = range->maximum};
    return refusal;
}

#endif
