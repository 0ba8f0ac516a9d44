/* Margins and dead bands of runs, relative to the scale of a quantity. They stand for rounding errors, and no
 * result may depend on them: a test builds pages with other factors. The generator reads this table, too.
 */
#ifndef TDMF_KERNEL_PAGE_MARGINS_H
#define TDMF_KERNEL_PAGE_MARGINS_H

#ifndef TDMF_MARGIN_FACTOR
#define TDMF_MARGIN_FACTOR 1.0
#endif

/* Below zero: up to here a guard, or a quantity that a decision compares, counts as zero. After thousands of
 * steps the states err by some thousand roundings. */
static const double zero_margin = TDMF_MARGIN_FACTOR * 1e-12;

/* Above zero: up to here a guard counts as zero where its mode begins. It has been evaluated at its zero,
 * with some tens of roundings. */
static const double rounding_margin = TDMF_MARGIN_FACTOR * 1e-14;

/* Below zero: up to here the guard of an event that was just taken need not be due again. An event is located
 * by a series that errs by 1e-10 at the default tolerance, see guard_tolerance. */
static const double late_margin = TDMF_MARGIN_FACTOR * 1e-9;

/* At a large tolerance an event is located roughly, and a guard that is zero at it may be further below zero.
 * The band grows by this share of the tolerance, because most series err by far less than it allows, up to
 * the second number, because a foot must not sink visibly. */
static const double rough_share = 1e-2, roughest = 1e-7;

#endif
