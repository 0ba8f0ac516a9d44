/* What every FMI call checks first, and the view it reads from. */
#include "fmi2_instance.h"

static const char *name_of_state(call_state state) {
    switch (state) {
    case INSTANTIATED:
        return "before initialization";
    case INITIALIZATION_MODE:
        return "in initialization mode";
    case EVENT_MODE:
        return "in event mode";
    case CONTINUOUS_TIME_MODE:
        return "in continuous-time mode";
    case TERMINATED:
        return "after termination";
    default:
        return "after an error; reset or free the instance";
    }
}

bool call_is_allowed(instance *instance, const char *call, unsigned allowed_states) {
    if (instance == NULL) {
        return false;
    }
    if ((instance->state & allowed_states) == 0) {
        fail(instance, call, "not allowed %s", name_of_state(instance->state));
        return false;
    }
    return true;
}

bool array_is_given(instance *instance, const char *call, const void *array, size_t count, size_t wanted) {
    if (count != wanted) {
        fail(instance, call, "the array has %lu elements, %lu are needed", (unsigned long)count,
             (unsigned long)wanted);
        return false;
    }
    if (array == NULL && count > 0) {
        fail(instance, call, "the array is a null pointer");
        return false;
    }
    return true;
}

void forget_view(instance *instance) {
    instance->view_is_current = false;
}

/* Until initialization is over, outputs are those of a run that would start from the values set so far. */
static bool look_ahead(instance *instance, const char *call, fmi2Status *status) {
    unit preview = instance->unit;
    const tdmf_refusal refusal = unit_start(&preview);
    if (refusal.variable != NULL) {
        char text[256];
        *status =
            discard(instance, call, "no outputs yet: %s", tdmf_refusal_text(&refusal, text, sizeof text));
        return false;
    }
    unit_look(&preview, &instance->view);
    return true;
}

const unit_view *current_view(instance *instance, const char *call, fmi2Status *status) {
    const bool before_start = (instance->state & (INSTANTIATED | INITIALIZATION_MODE)) != 0;
    if (!instance->view_is_current) {
        if (before_start) {
            if (!look_ahead(instance, call, status)) {
                return NULL;
            }
        } else {
            unit_look(&instance->unit, &instance->view);
        }
        instance->view_is_current = true;
    }
    return &instance->view;
}
