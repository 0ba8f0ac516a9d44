/* The products of series that the two motions are made of. Of each only the part without coefficient 0 of a
 * factor is summed at once: those terms hold the newest coefficients, which are not at hand yet.
 *
 * How factors are kept and summed is the business of whoever includes the motions: scalar_series.h for one
 * runner, lane_series.h for several side by side. Both have defined `real` before. */
#ifndef TDMF_KERNEL_SERIES_PRODUCTS_H
#define TDMF_KERNEL_SERIES_PRODUCTS_H

/* In flight: r r, r^2 w, r w, (r w) w, w w, v v. */
enum {
    FLIGHT_LENGTH_LENGTH,
    FLIGHT_SQUARE_RATE,
    FLIGHT_LENGTH_RATE,
    FLIGHT_ACROSS_RATE,
    FLIGHT_RATE_RATE,
    FLIGHT_SPEED_SPEED,
    FLIGHT_PRODUCTS
};

/* One coefficient of each factor. */
typedef struct {
    real length, square, across, angle_rate, length_rate;
} flight_factor;

/* Of a place on the ground: X X, Y Y, r r, one coefficient ahead of the rest. */
enum { PLACE_X_X, PLACE_Y_Y, PLACE_LENGTH_LENGTH, PLACE_PRODUCTS };

/* Of a standing leg: r a, X a, Y a, r^2 b, X b, Y b, r^2 w, rdot rdot; where the foot is free also Y udot and
 * the loss: friction by u in slip, tau by w in graze. */
enum {
    LENGTH_AXIAL,
    X_AXIAL,
    Y_AXIAL,
    SQUARE_TURNING,
    X_TURNING,
    Y_TURNING,
    SQUARE_RATE,
    SPEED_SPEED,
    STICK_PRODUCTS,
    Y_ACCELERATION = STICK_PRODUCTS,
    LOSS,
    FREE_PRODUCTS
};

typedef struct {
    real length, x, y, square;
    real axial, turning, angle_rate, length_rate;
    real acceleration, loss_left, loss_right; /* where the foot is free */
} ground_factor;

#endif
