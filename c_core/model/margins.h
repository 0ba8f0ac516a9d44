/* Margins around zero, in units of the quantity's scale. page_margins.h has those of the kernel. */
#ifndef TDMF_MODEL_MARGINS_H
#define TDMF_MODEL_MARGINS_H

/* Half-width of the band around zero in which a quantity that may settle there counts as unchanged. */
#define TDMF_DEAD_BAND 1e-10

/* Up to this distance below the ground, a start is at the ground. */
#define TDMF_AT_GROUND 1e-12

/* Up to this distance, a foot is on a border of a patch, which belongs to where the foot is going. */
#define TDMF_ON_BORDER 1e-12

/* Width, in v_s, of the layer in which friction falls: e^-60 is 1e-26. */
#define TDMF_LAYER_WIDTH 60.0

/* A layer narrower than this is refused: its v_s would be near to the margins in which a velocity counts as
 * zero, and a slip that it ends would not be told from one that begins. */
#define TDMF_NARROWEST_LAYER 1e-11

#endif
