/* Co-Simulation: the unit integrates itself. Without event mode an event inside a step is its own business:
 * it is located and taken, and the step ends exactly where the importer wants it. */
#include "instance.h"

#include <float.h>
#include <math.h>

/* What importers that add up or scale their times may be off by: rounding, and a share of the step. */
static double clock_rounding(double time, double step) {
    return 16.0 * DBL_EPSILON * fabs(time) + 1e-6 * step;
}

call_status step_on(instance *instance, const char *call, double time, double step, bool stop_at_event,
                    bool *event) {
    if (!call_is_allowed(instance, call, STEP_MODE)) {
        return CALL_ERROR;
    }
    fmu *fmu = &instance->fmu;
    if (!(step > 0.0 && fmu_is_time(time + step))) {
        return refuse(instance, call, "the step is not a positive number");
    }
    if (!(time + step > time)) {
        char length[TIME_CAPACITY], clock[TIME_CAPACITY];
        return refuse(instance, call, "a step of %s s is lost in the rounding of the time, %s s",
                      time_text(step, length), time_text(time, clock));
    }
    const double allowed = clock_rounding(time, step);
    if (!(fabs(time - fmu_time(fmu)) <= allowed)) {
        return refuse(instance, call, "the communication point is not where the last step ended");
    }
    if (time + step > fmu->stop_time + allowed) {
        char stop[TIME_CAPACITY];
        return refuse(instance, call, "the step goes beyond the stop time, %s s",
                      time_text(fmu->stop_time, stop));
    }
    const fmu_observer observer = event_logger(instance);
    char text[FMU_TEXT];
    const char *obstacle =
        (stop_at_event ? fmu_advance_to_event : fmu_advance)(fmu, time + step, &observer, text);
    discard_view(instance);
    *event = fmu->event_is_pending;
    return obstacle == NULL ? CALL_OK : fail(instance, call, "%s", obstacle);
}
