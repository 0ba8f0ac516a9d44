/* The hip's torque as the world asks for it; equations/hip.py has the laws. */
#include "tdmf_slip/hip.h"

#include "evaluation.h"

double tdmf_hip_torque(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(system, mode, state).torque;
}
