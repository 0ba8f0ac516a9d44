/* The page's values and what is read off a run, by the offsets of the generated tables. */
#include "values.h"

#include <string.h>

live_shared live;

static double values[LIVE_VALUE_CAPACITY];
static double outputs[LIVE_OUTPUT_CAPACITY];

/* Parameters, then inputs, in the order of the table. */
LIVE_EXPORT(live_values)
double *live_values_address(void) {
    return values;
}

LIVE_EXPORT(live_value_count)
int live_values_counted(void) {
    return live_value_count;
}

LIVE_EXPORT(live_outputs)
double *live_outputs_address(void) {
    return outputs;
}

LIVE_EXPORT(live_output_count)
int live_outputs_counted(void) {
    return live_output_count;
}

LIVE_EXPORT(live_section)
double *live_section_address(void) {
    return live.section;
}

LIVE_EXPORT(live_message)
const char *live_message_address(void) {
    return live.message;
}

/* A flag is set by any number but 0. */
static void write_value(tdmf_parameters *parameters, tdmf_inputs *inputs, const live_value *value,
                        double number) {
    const bool truth = number != 0.0;
    char *member = (value->group == LIVE_INPUT ? (char *)inputs : (char *)parameters) + value->offset;
    if (value->group == LIVE_FLAG) {
        memcpy(member, &truth, sizeof truth);
    } else {
        memcpy(member, &number, sizeof number);
    }
}

bool live_refused(const tdmf_refusal *refusal) {
    live.message[0] = '\0';
    if (refusal->variable == NULL) {
        return false;
    }
    tdmf_refusal_text(refusal, live.message, sizeof live.message);
    return true;
}

/* Makes model and inputs of the values. Where one is refused, nothing changes, and the message says why. */
LIVE_EXPORT(live_accept)
bool live_accept(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_model model;
    for (int i = 0; i < live_value_count; ++i) {
        write_value(&parameters, &inputs, &live_values[i], values[i]);
    }
    tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    if (refusal.variable == NULL) {
        refusal = tdmf_check_inputs(&inputs);
    }
    if (live_refused(&refusal)) {
        return false;
    }
    live.model = model;
    live.inputs = inputs;
    return true;
}

void live_write_outputs(const tdmf_outputs *from, const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < live_output_count; ++i) {
        const live_output *output = &live_outputs[i];
        const char *offset = (const char *)from + output->offset;
        int integer = 0;
        bool truth = false;
        switch (output->kind) {
        case LIVE_STATE:
            outputs[i] = state[output->offset];
            break;
        case LIVE_DOUBLE:
            memcpy(&outputs[i], offset, sizeof outputs[i]);
            break;
        case LIVE_BOOL:
            memcpy(&truth, offset, sizeof truth);
            outputs[i] = truth;
            break;
        default:
            memcpy(&integer, offset, sizeof integer);
            outputs[i] = integer;
        }
    }
}
