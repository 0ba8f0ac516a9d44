/* Positive work of the hip of a leg that whirls about the body, a hundred times as long as at rest: as an
 * independent integration has it, at every tolerance, by both solvers. */
#include "compare.h"
#include "simulation.h"
#include "system_of.h"

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

/* Of the default runner, from an apex with the leg at 0.3 rad; the works after 100 s in flight by SciPy's
 * DOP853 at 3e-14 on the equations of the two masses alone, split where torque or rate change their signs. */
typedef struct {
    double height, length, length_rate, angle_rate;
    double positive_work, work;
} whirl;

enum { WHIRLS = 3 };
static const whirl whirls[WHIRLS] = {
    {200.0, 60.0, 0.0, 3.3, 1467.7408724758918, -2025.3082258834435},
    {300.0, 100.0, 0.0, 0.5, 1340.4881196975, -112.12452334817},
    {300.0, 20.0, 5.0, 2.0, 398.38098977454, -118.69706387470},
};

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    double section[TDMF_SECTION_COUNT];
    tdmf_motion motion;
} scene;

static scene begin(const whirl *whirl) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    const double section[TDMF_SECTION_COUNT] = {whirl->height,    1.0, whirl->length, 0.3, whirl->length_rate,
                                                whirl->angle_rate};
    scene scene;
    memset(&scene, 0, sizeof scene);
    scene.model = accepted_model(&parameters);
    scene.inputs = tdmf_default_inputs();
    memcpy(scene.section, section, sizeof section);
    tdmf_section_state(SYSTEM_OF(&scene), section, scene.motion.state);
    scene.motion.time = 0.0;
    assert_null(tdmf_start(SYSTEM_OF(&scene), &scene.motion).variable);
    return scene;
}

TEST(the_native_solver_has_it_at_every_tolerance) {
    static const double tolerances[] = {1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
    for (int i = 0; i < 5 * WHIRLS; ++i) {
        const whirl *whirl = &whirls[i / 5];
        const double tolerance = fmax(10.0 * tolerances[i % 5], 1e-12);
        scene scene = begin(whirl);
        tdmf_solver solver = solver_to(tolerances[i % 5]);
        assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&scene), NULL, 100.0, &scene.motion),
                         TDMF_ARRIVED);
        assert_int_equal(scene.motion.mode.contact, TDMF_CONTACT_FLIGHT);
        assert_relatively_close(scene.motion.state[TDMF_HIP_POSITIVE_WORK], whirl->positive_work, tolerance);
        assert_relatively_close(scene.motion.state[TDMF_HIP_WORK], whirl->work, 10.0 * tolerance);
    }
}

TEST(cvode_has_it) {
    for (int i = 0; i < WHIRLS && tdmf_cvode_is_available(); ++i) {
        scene scene = begin(&whirls[i]);
        tdmf_solver solver = solver_to(1e-12);
        assert_int_equal(tdmf_cvode_advance(&solver, SYSTEM_OF(&scene), NULL, 100.0, &scene.motion),
                         TDMF_ARRIVED);
        assert_relatively_close(scene.motion.state[TDMF_HIP_POSITIVE_WORK], whirls[i].positive_work, 1e-8);
    }
}
