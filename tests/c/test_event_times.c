/* Times of events: that of a guard's zero, in every solver, however weak gravity is. */
#include "compare.h"
#include "references.h"
#include "simulation.h"
#include "system_of.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

static const double tightest = 1e-13;

/* ---- a stride, by whichever solver --------------------------------------------------------------------- */

static void start(simulation *run, const tdmf_parameters *parameters, double friction, double tolerance,
                  const double apex[TDMF_SECTION_COUNT]) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = friction;
    *run = simulation_from(parameters, &inputs, apex, tolerance);
}

static void start_on_gait(simulation *run, const proved_gait *gait, double tolerance) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.swing_clamp = true; /* the proof's setting */
    start(run, &parameters, gait->friction, tolerance, gait->apex);
}

static void assert_event_times(const simulation *run, const proved_event *events, int count,
                               double tolerance) {
    assert_int_equal(run->log.count, count);
    for (int i = 0; i < count; ++i) {
        assert_int_equal(run->log.events[i].guard, events[i].guard);
        assert_relatively_close(run->log.events[i].time, events[i].time, tolerance);
    }
}

/* ---- against proved values ----------------------------------------------------------------------------- */

TEST(events_of_the_published_gaits_have_the_proved_times) {
    simulation run;
    for (int i = 0; i < PROVED_GAITS; ++i) {
        const proved_gait *gait = &proved_gaits[i];
        start_on_gait(&run, gait, tightest);
        simulation_stride(&run);
        assert_event_times(&run, gait->events, gait->event_count, 3e-15);
        assert_relatively_close(last_stride_of(&run.motion).period, gait->period, 3e-15);
        assert_relatively_close(last_stride_of(&run.motion).length, gait->length, 1e-14);
        assert_relatively_close(last_apex_of(&run.motion).com_height, gait->apex[0], 1e-14);
    }
}

/* A tolerance bounds what steps err by; events add nothing to that. */
TEST(events_add_nothing_to_the_error_of_any_tolerance) {
    simulation run;
    for (double tolerance = 1e-12; tolerance < 1e-7; tolerance *= 10.0) {
        for (int i = 0; i < PROVED_GAITS; ++i) {
            start_on_gait(&run, &proved_gaits[i], tolerance);
            simulation_stride(&run);
            assert_relatively_close(last_stride_of(&run.motion).period, proved_gaits[i].period,
                                    0.1 * tolerance);
        }
    }
}

TEST(a_search_finds_the_proved_gaits) {
    simulation run;
    for (int i = 0; i < PROVED_GAITS; ++i) {
        const proved_gait *gait = &proved_gaits[i];
        double guess[TDMF_SECTION_COUNT];
        memcpy(guess, gait->apex, sizeof guess);
        guess[TDMF_SECTION_COM_SPEED] *= 1.001;
        start_on_gait(&run, gait, 1e-12);
        const tdmf_orbit orbit = find_orbit(TDMF_RETURN_MAP, &run.solver, SYSTEM_OF(&run), guess, NULL, 0);
        assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
        assert_relatively_close(orbit.stride.stride.period, gait->period, 1e-13);
        assert_relatively_close(orbit.apex[0], gait->apex[0], 1e-13);
    }
}

TEST(the_clock_of_a_run_goes_with_its_gait) {
    enum { STRIDES = 100 };
    simulation run;
    start_on_gait(&run, &proved_gaits[2], 1e-12);
    for (int i = 0; i < STRIDES; ++i) {
        simulation_stride(&run);
    }
    assert_relatively_close(run.motion.time, STRIDES * proved_gaits[2].period, 3e-14);
}

/* ---- against strides in extended precision --------------------------------------------------------------
 */

/* The clamp's kink is no event: its argument settles at zero, where rounding decides. */
static int assert_events_but_clamps(const simulation *run, const proved_event *events, double tolerance) {
    int count = 0;
    for (int i = 0; i < run->log.count; ++i) {
        const tdmf_event *event = &run->log.events[i];
        if (event->guard != TDMF_GUARD_CLAMP) {
            assert_int_equal(event->guard, events[count].guard);
            assert_relatively_close(event->time, events[count].time, tolerance);
            ++count;
        }
    }
    return count;
}

TEST(strides_under_any_gravity_have_the_events_of_extended_precision) {
    int compared = 0, total = 0;
    for (int i = 0; i < EXTENDED_STRIDES; ++i) {
        const extended_stride *expected = &extended_strides[i];
        const tdmf_parameters parameters = parameters_of_stride(expected);
        simulation run;
        start(&run, &parameters, expected->friction, tightest, expected->start);
        simulation_stride(&run);
        compared += assert_events_but_clamps(&run, expected->events, 1e-12);
        double apex[TDMF_SECTION_COUNT];
        read_apex(&run.motion, apex);
        assert_all_close(apex, expected->apex, expected->apex_count, 1e-12, 1e-12);
        total += expected->event_count;
    }
    assert_int_equal(compared, total);
    assert_true(total >= 5 * EXTENDED_STRIDES);
}

/* Its clamp's argument settles at zero up to rounding long before the apex, where no step of extended
 * precision tells which side it is on; so the other solver tells. */
TEST(a_stride_under_the_weakest_gravity_is_that_of_the_other_solver) {
    static const double apex[TDMF_SECTION_COUNT] = {1.3, 0.1, 1.0, 1.0, 0.0, 0.0};
    tdmf_parameters parameters = tdmf_default_parameters();
    simulation native, other;
    skip_without_cvode();
    parameters.gravity = 1e-4;
    parameters.hip.swing_clamp = true;
    start(&native, &parameters, 0.6, tightest, apex);
    simulation_stride(&native);
    start(&other, &parameters, 0.6, tightest, apex);
    assert_int_equal(
        simulation_advance_by(tdmf_cvode_advance, &other, last_stride_of(&native.motion).period + 1.0),
        TDMF_ARRIVED);
    assert_int_equal(other.motion.state[TDMF_STRIDE_COUNT], 1);
    assert_relatively_close(last_stride_of(&native.motion).period, last_stride_of(&other.motion).period,
                            1e-9);
    assert_relatively_close(last_apex_of(&native.motion).com_height, last_apex_of(&other.motion).com_height,
                            1e-9);
}

/* Its own steps err by more than any margin makes. Where it finds the apex its root search tells. */
TEST(cvode_finds_the_apex_where_the_center_of_mass_stops_rising) {
    skip_without_cvode();
    for (int i = 0; i < PROVED_GAITS; ++i) {
        const proved_gait *gait = &proved_gaits[i];
        simulation run;
        start_on_gait(&run, gait, 1e-14);
        assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &run, gait->period + 1.0), TDMF_ARRIVED);
        const tdmf_event *apex = &run.log.events[run.log.count - 1];
        assert_int_equal(apex->guard, TDMF_GUARD_APEX);
        assert_close(tdmf_center_of_mass(&run.model, apex->state).vy, 0.0, TDMF_GUARD_MARGIN + 2e-14);
        assert_relatively_close(last_stride_of(&run.motion).period, gait->period, 1e-10);
    }
}
