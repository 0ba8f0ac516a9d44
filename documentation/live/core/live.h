/* Functions of the core that the live page's JavaScript calls. Numbers go through arrays of doubles, whose
 * offsets the page's own table gives by name. An instance has one runner. No physics here. */
#ifndef LIVE_H
#define LIVE_H

#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/tdmf_slip.h"

/* A function that the page calls. */
#define LIVE_EXPORT(name) __attribute__((export_name(#name)))

enum { LIVE_MESSAGE_CAPACITY = 512 };

/* State that all files share. */
typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    double section[TDMF_SECTION_COUNT];  /* an apex, handed in or out */
    char message[LIVE_MESSAGE_CAPACITY]; /* a sentence on the last refusal or failure; else empty */
} live_shared;
extern live_shared live;

static inline tdmf_system live_system(void) {
    const tdmf_system system = {&live.model, &live.inputs};
    return system;
}

/* ---- derived from c_core/pages ------------------------------------------------------------------------- */

typedef enum { LIVE_PARAMETER, LIVE_FLAG, LIVE_INPUT } live_group;
typedef struct {
    live_group group;
    size_t offset; /* in tdmf_parameters, of a double or a bool, or in tdmf_inputs */
} live_value;
extern const live_value live_values[];
extern const int live_value_count;
enum { LIVE_VALUE_CAPACITY = 64, LIVE_OUTPUT_CAPACITY = 96 };

typedef enum { LIVE_STATE, LIVE_DOUBLE, LIVE_INT, LIVE_BOOL } live_kind;
typedef struct {
    live_kind kind;
    size_t offset; /* of a state its index, else the offset in tdmf_outputs */
} live_output;
extern const live_output live_outputs[];
extern const int live_output_count;

#endif
