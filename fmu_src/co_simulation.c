/* Co-Simulation: the unit integrates itself. Without event mode an event inside a step is its own business:
 * it is located and taken, and the step ends exactly where the importer wants it. */
#include "instance.h"

#include <math.h>

/* Communication points that importers add up may be off by so much, over the larger of time and step. */
static const double clock_rounding = 1e-9;

static bool is_communication_point(const unit *unit, double time, double step) {
    const double own = unit->motion.time;
    return fabs(time - own) <= clock_rounding * fmax(fabs(own), step);
}

call_status step_on(instance *instance, const char *call, double time, double step, bool stop_at_event,
                    bool *event) {
    if (!call_is_allowed(instance, call, STEP_MODE)) {
        return CALL_ERROR;
    }
    unit *unit = &instance->unit;
    if (!(step > 0.0 && isfinite(step) && isfinite(time + step))) {
        return fail(instance, call, "the step is not a positive number");
    }
    if (!is_communication_point(unit, time, step)) {
        return fail(instance, call, "the communication point is not where the last step ended");
    }
    const tdmf_mode before = unit->motion.mode;
    const char *obstacle =
        stop_at_event ? unit_advance_to_event(unit, time + step) : unit_advance(unit, time + step);
    forget_view(instance);
    log_changes(instance, &before);
    *event = unit->event_is_pending;
    return obstacle == NULL ? CALL_OK : fail(instance, call, "%s", obstacle);
}
