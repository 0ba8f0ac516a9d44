/* Saved and serialized states. A saved state is a copy of the unit, which holds no pointer, behind a
 * header that tells whether it is ours: it restores in any instance and, serialized, in any process. */
#include "guid.h"
#include "instance.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    char guid[40];       /* of the unit that saved it: its variables and version */
    uint32_t byte_order; /* reads otherwise on a machine of another kind */
    uint32_t size;
    uint64_t checksum; /* of what follows */
} header;

typedef struct {
    header header;
    struct {
        interface_kind interface;
        call_state state;
        unit unit;
    } content;
} saved_state;

/* FNV-1a */
static uint64_t checksum_of(const saved_state *saved) {
    const unsigned char *bytes = (const unsigned char *)&saved->content;
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < sizeof saved->content; ++i) {
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
    return hash;
}

static void fill(saved_state *saved, const instance *instance) {
    memset(saved, 0, sizeof *saved);
    memcpy(saved->header.guid, UNIT_GUID, sizeof UNIT_GUID);
    saved->header.byte_order = 0x01020304;
    saved->header.size = sizeof *saved;
    saved->content.interface = instance->interface;
    saved->content.state = instance->state;
    memcpy(&saved->content.unit, &instance->unit, sizeof instance->unit);
    saved->header.checksum = checksum_of(saved);
}

/* Why these bytes are no state of this unit, or NULL. */
static const char *reason_to_reject(const saved_state *saved) {
    if (saved->header.byte_order != 0x01020304 || saved->header.size != sizeof *saved) {
        return "it was saved by another program or on another kind of machine";
    }
    if (memcmp(saved->header.guid, UNIT_GUID, sizeof UNIT_GUID) != 0) {
        return "it was saved by another version of the unit";
    }
    if (saved->header.checksum != checksum_of(saved)) {
        return "its bytes have been changed";
    }
    return NULL;
}

call_status save_state(instance *instance, const char *call, void **state) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, state, 1, 1)) {
        return CALL_ERROR;
    }
    saved_state *saved = *state != NULL ? *state : malloc(sizeof *saved);
    if (saved == NULL) {
        return fail(instance, call, "out of memory");
    }
    fill(saved, instance);
    *state = saved;
    return CALL_OK;
}

call_status restore_state(instance *instance, const char *call, const void *state) {
    const saved_state *saved = state;
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    if (saved == NULL) {
        return discard(instance, call, "the state is a null pointer");
    }
    const char *reason = reason_to_reject(saved);
    if (reason == NULL && saved->content.interface != instance->interface) {
        reason = "it was saved in another interface";
    }
    if (reason != NULL) {
        return discard(instance, call, "the state is refused: %s", reason);
    }
    const int other = unit_first_difference(&instance->unit, &saved->content.unit);
    if (other >= 0) {
        return discard(instance, call, "the state is refused: it was saved with another value of %s",
                       unit_variables[other].name);
    }
    memcpy(&instance->unit, &saved->content.unit, sizeof instance->unit);
    instance->state = saved->content.state;
    forget_view(instance);
    return CALL_OK;
}

call_status free_state(instance *instance, const char *call, void **state) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    if (state != NULL) {
        free(*state);
        *state = NULL;
    }
    return CALL_OK;
}

call_status measure_state(instance *instance, const char *call, const void *state, size_t *size) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, state, 1, 1) ||
        !array_is_given(instance, call, size, 1, 1)) {
        return CALL_ERROR;
    }
    *size = sizeof(saved_state);
    return CALL_OK;
}

call_status serialize_state(instance *instance, const char *call, const void *state, void *bytes,
                            size_t size) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, state, 1, 1) ||
        !array_is_given(instance, call, bytes, size, sizeof(saved_state))) {
        return CALL_ERROR;
    }
    memcpy(bytes, state, sizeof(saved_state));
    return CALL_OK;
}

call_status deserialize_state(instance *instance, const char *call, const void *bytes, size_t size,
                              void **state) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, bytes, 1, 1) ||
        !array_is_given(instance, call, state, 1, 1)) {
        return CALL_ERROR;
    }
    if (size != sizeof(saved_state)) {
        return discard(instance, call, "%lu bytes are no state of this unit, which has %lu",
                       (unsigned long)size, (unsigned long)sizeof(saved_state));
    }
    saved_state incoming;
    memcpy(&incoming, bytes, sizeof incoming);
    const char *reason = reason_to_reject(&incoming);
    if (reason != NULL) {
        return discard(instance, call, "the bytes are refused: %s", reason);
    }
    saved_state *saved = *state != NULL ? *state : malloc(sizeof *saved);
    if (saved == NULL) {
        return fail(instance, call, "out of memory");
    }
    memcpy(saved, &incoming, sizeof incoming);
    *state = saved;
    return CALL_OK;
}
