/* Included before every file of the extended build: the whole core in long double. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tgmath.h>

/* What the core calls so is double there, for bits are looked at. */
typedef double binary64;

#define double long double
