/* When a search for gaits or an ensemble gives a stride up. */
#ifndef TDMF_SOLVER_LONGEST_STRIDE_H
#define TDMF_SOLVER_LONGEST_STRIDE_H

/* In sqrt(m/k): a stride that takes longer counts as none. */
#define TDMF_LONGEST_STRIDE 1e4

#endif
