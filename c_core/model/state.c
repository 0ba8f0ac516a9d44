/* The line of ground, and the default start. */
#include "tdmf_slip/state.h"

#include "ranges.h"

#include <math.h>
#include <string.h>

tdmf_ground_line tdmf_ground_line_of(double height, double slope) {
    const tdmf_ground_line line = {height, slope, sin(slope), cos(slope)};
    return line;
}

void tdmf_default_state(double state[TDMF_STATE_COUNT]) {
    memset(state, 0, TDMF_STATE_COUNT * sizeof *state);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        state[TDMF_FOOT_X + i] = tdmf_state_ranges[i].start;
    }
}
