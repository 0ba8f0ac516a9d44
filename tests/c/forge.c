#include "forge.h"

#include <stdint.h>
#include <string.h>

void forge_checksum(unsigned char *bytes, size_t size) {
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = FORGE_CONTENT; i < size; ++i) {
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
    memcpy(bytes + FORGE_CHECKSUM, &hash, sizeof hash);
}
