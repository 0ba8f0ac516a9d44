/* The paper's gaits, without the clamp of (12) and with it, against reference values that were computed
 * independently in extended precision.
 *
 * A run starts at the reference's apex and must come back to it after one stride, through the same events at
 * the same times. Runge-Kutta of fourth order at this step is good to some 1e-12 per stride. The apex is the
 * worst placed of the events: gravity of 0.01 turns an error of 1e-12 in speed into one of 1e-10 in time. */
#include "compare.h"
#include "integrate.h"
#include "reference_gaits.h"

#include <math.h>
#include <string.h>

static const double step = 1e-3;
static const double relative = 1e-10;
static const double event_time = 1e-9;
static const double clamp_time = 1e-8; /* its guard has a dead band of 1e-10, which takes 5e-9 to cross */

/* ---- one stride ------------------------------------------------------------------------------------- */

TEST(strides_close_on_the_reference) {
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        runner runner = runner_at_reference_apex(&reference_gaits[i]);
        runner_stride(&runner, step);
        assert_reference_stride(&runner.motion, &reference_gaits[i], relative);
    }
}

/* ---- its events ------------------------------------------------------------------------------------- */

static bool slips(tdmf_contact_mode contact) {
    return contact == TDMF_CONTACT_SLIP_POSITIVE || contact == TDMF_CONTACT_SLIP_NEGATIVE;
}

/* What happened between two modes of a running gait; 0 if only a peak of the force was noted. */
static int event_between(const tdmf_mode *before, const tdmf_mode *after) {
    if (before->contact == after->contact) {
        return before->phase == TDMF_PHASE_DRIVE && after->phase == TDMF_PHASE_COAST     ? MID_STANCE
               : before->phase == TDMF_PHASE_RETRACT && after->phase == TDMF_PHASE_PLACE ? APEX
               : before->clamp_closed != after->clamp_closed                             ? CLAMP_RELEASE
                                                                                         : 0;
    }
    if (before->contact == TDMF_CONTACT_FLIGHT) {
        return TOUCHDOWN;
    }
    if (before->contact == TDMF_CONTACT_GRAZE) {
        return GRAZE_END;
    }
    if (after->contact == TDMF_CONTACT_GRAZE) {
        return LIFT_OFF_INTO_GRAZE;
    }
    return slips(before->contact) ? SLIP_VELOCITY_ZERO : SLIP_ONSET;
}

/* Advances to the next event of the gait and returns its kind. */
static int next_event(runner *runner) {
    int kind = 0;
    while (kind == 0) {
        const tdmf_mode before = runner->motion.mode;
        assert_true(runner_advance(runner, step));
        kind = event_between(&before, &runner->motion.mode);
    }
    return kind;
}

TEST(events_happen_in_order_and_in_time) {
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        runner runner = runner_at_reference_apex(&reference_gaits[i]);
        const reference_event *expected = reference_gaits[i].events;
        int counted = 0;
        for (; expected->kind != 0; ++expected) {
            assert_int_equal(next_event(&runner), expected->kind);
            const bool clamp = expected->kind == CLAMP_RELEASE;
            assert_close(runner.motion.time, expected->time, clamp ? clamp_time : event_time);
            counted += !clamp;
        }
        assert_int_equal(runner.motion.record.event_count, counted);
        assert_int_equal(runner.motion.record.stride.count, 1);
    }
}

/* The gait is stable: strides go on alike, event for event. */
TEST(strides_repeat) {
    runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    for (int stride = 1; stride <= 20; ++stride) {
        runner_stride(&runner, step);
        assert_int_equal(runner.motion.record.event_count, 9 * stride);
        assert_string_equal(runner.motion.record.stride.word, reference_gaits[DEFAULT_GAIT].word);
        assert_relatively_close(runner.motion.record.stride.period, reference_gaits[DEFAULT_GAIT].period,
                                1e-9);
    }
}
