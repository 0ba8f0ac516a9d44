/* Sums of two doubles without loss: Knuth's TwoSum, and Dekker's where the first is the larger. */
#include "instant.h"

tdmf_instant tdmf_instant_after(tdmf_instant from, double elapsed) {
    const double sum = from.time + elapsed;
    const double part = sum - from.time;
    const double lost = (from.time - (sum - part)) + (elapsed - part);
    const double rest = from.rest + lost;
    tdmf_instant after;
    after.time = sum + rest;
    after.rest = rest - (after.time - sum);
    return after;
}

double tdmf_time_between(tdmf_instant from, tdmf_instant to) {
    return (to.time - from.time) + (to.rest - from.rest);
}

tdmf_instant tdmf_instant_of(const tdmf_motion *motion) {
    const tdmf_instant rounded = {motion->time, 0.0};
    return motion->record.progress.now.time == motion->time ? motion->record.progress.now : rounded;
}
