/* Events at which a runner's lane goes on as it is but for a law, of the hip or of friction: a slip begins or
 * comes to rest, a drive ends at mid-stance, the clamp opens or closes. The leg keeps the coordinates of its
 * motion and most of its constants, so that neither a state nor a mode's equations need be made of them. What
 * the change may make due at once is asked here; where something is, nothing is changed. */
#include "runner.h"

#include "constant_laws.h"
#include "coordinate_laws.h"
#include "friction.h"
#include "hip_law.h"
#include "input_rates.h"
#include "mode_change.h"
#include "step_constants.h"
#include "tdmf_slip/contact.h"

#include "members.h"

#include <math.h>

/* Where a stride is noted, friction falls or there is a patch, an event takes more than is done here. */
static bool takes_more(const tdmf_runner *runner) {
    return tdmf_records_strides(runner->ensemble) || tdmf_has_patch(runner->model) ||
           tdmf_friction_falls(runner->model) || runner->events_left <= 1;
}

bool tdmf_runner_may_change_law(const tdmf_runner *runner, tdmf_guard reached) {
    switch (reached) {
    case TDMF_GUARD_CLAMP:
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return !takes_more(runner);
    case TDMF_GUARD_MID_STANCE:
        return tdmf_is_loaded(&runner->motion.mode) && !takes_more(runner);
    default:
        return false;
    }
}

/* ---- in flight ---------------------------------------------------------------------------------------- */

static void change_clamp(tdmf_runner *runner, flying_member *m) {
    const tdmf_model *model = runner->model;
    tdmf_mode *mode = &runner->motion.mode;
    tdmf_change_mode(model, runner->motion.state, TDMF_GUARD_CLAMP, mode);
    const double place_time = runner->motion.state[TDMF_HIP_PLACE_TIME];
    const tdmf_hip_law servo = tdmf_servo(model, &runner->inputs, mode, place_time);
    m->constants.law = tdmf_flight_coefficients_in(model, &runner->inputs, mode, place_time);
    m->constants.servo = tdmf_signed_law(&servo, mode->clamp_closed ? -1.0 : 1.0);
    m->constants.mode.margin_factor = tdmf_margin_factor(0);
}

/* ---- in stance ---------------------------------------------------------------------------------------- */

/* A torque that jumps may lift the foot or push it out of the cone, in which one that comes to rest may not
 * be. No force jumps where a slip begins. */
static bool lasts(const tdmf_runner *runner, const tdmf_mode *mode, const tdmf_standing *at, double torque,
                  tdmf_guard reached) {
    const tdmf_system system = tdmf_runner_system(runner);
    if (reached == TDMF_GUARD_SLIP_ONSET_POSITIVE || reached == TDMF_GUARD_SLIP_ONSET_NEGATIVE) {
        return true;
    }
    const tdmf_ground_force force = tdmf_force_on_standing(
        system.model, &mode->ground, at, tdmf_rest_length(system.model, system.inputs, mode), torque);
    return force.normal > 0.0 &&
           (mode->contact != TDMF_CONTACT_STICK ||
            tdmf_inside_friction_cone(force, tdmf_static_friction(system.model, system.inputs, mode->zone)));
}

/* Goes to the instant and the place of the event, and takes it. */
static void take(tdmf_runner *runner, standing_member *m, tdmf_guard reached) {
    tdmf_motion *motion = &runner->motion;
    tdmf_run run = {tdmf_runner_system(runner), motion, runner->direction};
    tdmf_runner_pass_time(runner, m->now.elapsed);
    m->time_left -= m->now.elapsed;
    m->now.elapsed = 0.0;
    tdmf_stand_foot(&motion->mode.ground, m->at.foot_x, m->at.at.foot_vx, motion->state);
    tdmf_take_mode_change(&run, reached);
}

static bool change_stance(tdmf_runner *runner, standing_member *m, tdmf_guard reached) {
    const tdmf_system system = tdmf_runner_system(runner);
    tdmf_mode mode = runner->motion.mode;
    tdmf_change_mode(system.model, runner->motion.state, reached, &mode);
    const double torque = tdmf_stance_law(system.model, system.inputs, &tdmf_zero_input_rates, &mode).torque;
    tdmf_mode_coordinates at;
    tdmf_step_set_ground(&at, &m->at);
    if (mode.contact == TDMF_CONTACT_STICK) {
        at.standing.foot_vx = 0.0;
    }
    if (!lasts(runner, &mode, &at.standing, torque, reached)) {
        return false;
    }
    m->at.at.foot_vx = at.standing.foot_vx;
    take(runner, m, reached);
    m->constants.law.torque = torque;
    m->constants.law.friction =
        tdmf_signed_friction(system.model, system.inputs, mode.zone, tdmf_sign_of_slip(&mode));
    m->constants.slip_sign = tdmf_sign_of_slip(&mode);
    m->constants.drives = mode.mid_stance_pending ? m->constants.drives : 0.0;
    m->constants.mode.margin_factor = tdmf_margin_factor(0);
    return true;
}

bool tdmf_runner_change_law(tdmf_runner *runner, double *fields, tdmf_guard reached) {
    if (reached == TDMF_GUARD_CLAMP) {
        change_clamp(runner, (flying_member *)fields);
    } else if (!change_stance(runner, (standing_member *)fields, reached)) {
        return false;
    }
    runner->false_crossings = 0;
    --runner->events_left;
    return true;
}
