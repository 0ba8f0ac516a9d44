/* What both maps make of a stride. */
#include "return_record.h"

tdmf_return_outcome tdmf_return_outcome_of(tdmf_stride_outcome ended) {
    if (ended.closed) {
        return TDMF_RETURN_CLOSED;
    }
    switch (ended.outcome) {
    case TDMF_ARRIVED:
        return TDMF_RETURN_TOO_LONG;
    case TDMF_FELL:
        return TDMF_RETURN_FELL;
    case TDMF_REFUSED:
        return TDMF_RETURN_REFUSED;
    default:
        return TDMF_RETURN_UNSOLVED;
    }
}

void tdmf_write_return(const tdmf_record *record, const double state[TDMF_STATE_COUNT], tdmf_return *result) {
    result->stride = record->stride;
    result->external_work = state[TDMF_ENERGY_EXTERNAL_WORK];
    result->damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    result->friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    result->impact_loss = record->impact_loss;
}

const char *tdmf_return_outcome_text(tdmf_return_outcome outcome) {
    switch (outcome) {
    case TDMF_RETURN_CLOSED:
        return "the stride has a next apex";
    case TDMF_RETURN_NO_START:
        return "there is no apex above the ground";
    case TDMF_RETURN_NO_TOUCHDOWN:
        return "the foot does not come down in the time that a stride may take";
    case TDMF_RETURN_NO_STANCE:
        return "the impact leaves the foot without load";
    case TDMF_RETURN_TOO_LONG:
        return "no stride closes in the time that it may take";
    case TDMF_RETURN_NO_APEX:
        return "the centre of mass does not rise at lift-off";
    case TDMF_RETURN_FELL:
        return "the runner fell";
    case TDMF_RETURN_UNSOLVED:
        return "the solver could not follow the runner";
    default:
        return "a value is out of range";
    }
}
