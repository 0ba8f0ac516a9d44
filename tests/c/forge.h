/* Serialized states as an attacker would make them: the header is 8 bytes of zero, 40 of identification, 4
 * each of byte order and size, and 8 of the checksum of what follows: 4 bytes each of interface and state of
 * the call sequence, whether the run has begun and whether an event is pending, and the rest of the run. */
#ifndef TDMF_TESTS_FORGE_H
#define TDMF_TESTS_FORGE_H

#include <stddef.h>

enum {
    FORGE_BYTE_ORDER = 48,
    FORGE_SIZE = 52,
    FORGE_CHECKSUM = 56,
    FORGE_CONTENT = 64,
    FORGE_CALL_STATE = 68,
    FORGE_BEGUN = 72,
    FORGE_PENDING = 76
};

/* Makes the checksum that of the present content. */
void forge_checksum(unsigned char *bytes, size_t size);

#endif
