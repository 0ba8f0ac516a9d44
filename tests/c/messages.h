/* Messages that units have sent to the tests' importers, and the variables that they name. */
#ifndef TDMF_TESTS_MESSAGES_H
#define TDMF_TESTS_MESSAGES_H

#include <stdint.h>

/* Messages since the last clear_messages; the first MESSAGES_KEPT of them are kept. */
enum { MESSAGES_KEPT = 512, MESSAGE_LENGTH = 160 };
extern int message_count;
extern char messages[MESSAGES_KEPT][MESSAGE_LENGTH];
extern char last_message[1024];
extern char last_category[64];
void clear_messages(void);

/* The category of what happens to the runner, as the calls that switch it want it. */
extern const char *const events_category[1];

/* Notes a message. */
void record_message(const char *category, const char *text);

/* Room for a saved state of either version. */
enum { SERIALIZED_BYTES = 8192 };

/* Value reference of a variable; asserts that it exists. */
uint32_t reference_of(const char *name);

#endif
