/* TDMF-SLIP: a legged runner whose foot can slip. This header brings in the whole core;
 * ensemble.h and cvode.h belong to libraries beside it.
 *
 * No pointer may be NULL unless its function says so. An array without elements may be NULL. Functions that
 * return an outcome, a refusal or whether they succeeded refuse NULL. Functions that evaluate an instant do
 * not check, and give NaN if the contact or phase is invalid. */
#ifndef TDMF_SLIP_TDMF_SLIP_H
#define TDMF_SLIP_TDMF_SLIP_H

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/eigenvalues.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/outputs.h"
#include "tdmf_slip/page.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/refusal.h"
#include "tdmf_slip/return_map.h"
#include "tdmf_slip/solver.h"
#include "tdmf_slip/state.h"
#include "tdmf_slip/stride.h"
#include "tdmf_slip/variables.h"
#include "tdmf_slip/version.h"

#endif
