/* Saved and serialized states. A saved state is the bytes of a run (see saved_fields.c) behind a header that
 * shows whether this unit wrote them. A serialized state has the same bytes. So it restores in any instance
 * and process, and everything in it is checked first. */
#include "guid.h"
#include "saved_fields.h"

#include <stdlib.h>
#include <string.h>

static const uint32_t byte_order = 0x01020304; /* reads otherwise on a machine of another kind */

typedef struct {
    uint64_t zero; /* an importer that frees a state where its address is due frees a null pointer */
    char guid[40]; /* of the unit that saved it: its variables and version */
    uint32_t byte_order;
    uint32_t size;
    uint64_t checksum; /* of what follows */
} header;

static size_t saved_size(void) {
    return sizeof(header) + saved_run_size();
}

static const unsigned char *content_of(const void *state) {
    return (const unsigned char *)state + sizeof(header);
}

/* FNV-1a */
static uint64_t checksum_of(const void *state) {
    const unsigned char *bytes = content_of(state);
    const size_t size = saved_run_size();
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < size; ++i) {
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
    return hash;
}

static header header_of(const void *state) {
    header header;
    memset(&header, 0, sizeof header);
    memcpy(header.guid, FMU_GUID, sizeof FMU_GUID);
    header.byte_order = byte_order;
    header.size = (uint32_t)saved_size();
    header.checksum = checksum_of(state);
    return header;
}

/* NULL, and the run that the state holds; or why it is refused, perhaps written into `reason`. */
static const char *read_state(const void *state, saved_run *run, char *reason, size_t capacity) {
    header found;
    memcpy(&found, state, sizeof found);
    const header wanted = header_of(state);
    if (found.byte_order != wanted.byte_order || found.size != wanted.size) {
        return "it was saved by another program or on another kind of machine";
    }
    if (found.zero != wanted.zero || memcmp(found.guid, wanted.guid, sizeof found.guid) != 0) {
        return "it was saved by another version of the unit";
    }
    if (found.checksum != wanted.checksum) {
        return "its bytes have been changed";
    }
    return read_saved_run(content_of(state), run, reason, capacity);
}

static void write_state(const instance *instance, unsigned char *state) {
    saved_run run = {instance->interface, instance->state, instance->fmu};
    write_saved_run(&run, state + sizeof(header));
    const header header = header_of(state);
    memcpy(state, &header, sizeof header);
}

/* A place for a state: the importer's old one if it has one. */
static unsigned char *room_for_state(void *old) {
    return old != NULL ? old : malloc(saved_size());
}

call_status save_state(instance *instance, const char *call, void **state) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, state, 1, 1)) {
        return CALL_ERROR;
    }
    unsigned char *saved = room_for_state(*state);
    if (saved == NULL) {
        return fail(instance, call, "out of memory");
    }
    write_state(instance, saved);
    *state = saved;
    return CALL_OK;
}

call_status restore_state(instance *instance, const char *call, const void *state) {
    char text[FMU_TEXT];
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    saved_run run = {.fmu = instance->fmu};
    if (state == NULL) {
        return discard(instance, call, "the state is a null pointer");
    }
    const char *reason = read_state(state, &run, text, sizeof text);
    if (reason == NULL && run.interface != instance->interface) {
        reason = "it was saved in another interface";
    }
    if (reason != NULL) {
        return discard(instance, call, "the state is refused: %s", reason);
    }
    instance->fmu = run.fmu;
    instance->state = run.state;
    discard_view(instance);
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
    *size = saved_size();
    return CALL_OK;
}

call_status serialize_state(instance *instance, const char *call, const void *state, void *bytes,
                            size_t size) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, state, 1, 1) ||
        !array_is_given(instance, call, bytes, size, saved_size())) {
        return CALL_ERROR;
    }
    memcpy(bytes, state, saved_size());
    return CALL_OK;
}

call_status deserialize_state(instance *instance, const char *call, const void *bytes, size_t size,
                              void **state) {
    char text[FMU_TEXT];
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, bytes, 1, 1) ||
        !array_is_given(instance, call, state, 1, 1)) {
        return CALL_ERROR;
    }
    saved_run run = {.fmu = instance->fmu};
    if (size != saved_size()) {
        return discard(instance, call, "%lu bytes are no state of this unit, which has %lu",
                       (unsigned long)size, (unsigned long)saved_size());
    }
    const char *reason = read_state(bytes, &run, text, sizeof text);
    if (reason != NULL) {
        return discard(instance, call, "the bytes are refused: %s", reason);
    }
    unsigned char *saved = room_for_state(*state);
    if (saved == NULL) {
        return fail(instance, call, "out of memory");
    }
    memcpy(saved, bytes, saved_size());
    *state = saved;
    return CALL_OK;
}
