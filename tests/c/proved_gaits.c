#include "proved_gaits.h"

#include "proved_gaits_table.h"
