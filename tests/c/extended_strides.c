#include "extended_strides.h"

#include "extended_strides_table.h"
