/* The hip's torque as the world asks for it; equations/hip.py has the laws. */
#include "tdmf_slip/hip.h"

#include "evaluation.h"

bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_local_seed *d) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->model.parameters;
    return tdmf_has_clamp(model, mode) && p->hip.kp == 0.0 && p->hip.kd == 0.0 &&
           (d_p->hip.kp != 0.0 || d_p->hip.kd != 0.0);
}

double tdmf_hip_torque(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(system, mode, state).torque;
}
