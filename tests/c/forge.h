/* Serialized states as an attacker would make them: the header is 40 bytes of identification, 4 each of byte
 * order and size, and 8 of the checksum of what follows: 4 bytes each of interface and state of the call
 * sequence, one that tells whether an event is pending, and the run. */
#ifndef TDMF_TESTS_FORGE_H
#define TDMF_TESTS_FORGE_H

#include <stddef.h>

enum {
    FORGE_BYTE_ORDER = 40,
    FORGE_SIZE = 44,
    FORGE_CHECKSUM = 48,
    FORGE_CONTENT = 56,
    FORGE_CALL_STATE = 60,
    FORGE_BEGUN = 64,
    FORGE_PENDING = 65
};

/* Makes the checksum that of the present content. */
void forge_checksum(unsigned char *bytes, size_t size);

#endif
