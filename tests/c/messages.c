#include "messages.h"

#include "compare.h"
#include "variables.h"

#include <stdio.h>
#include <string.h>

int message_count;
char messages[MESSAGES_KEPT][MESSAGE_LENGTH];
char last_message[1024];
char last_category[64];

const char *const events_category[1] = {"logEvents"};

void clear_messages(void) {
    message_count = 0;
    last_message[0] = '\0';
    last_category[0] = '\0';
}

void record_message(const char *category, const char *text) {
    snprintf(last_category, sizeof last_category, "%s", category);
    snprintf(last_message, sizeof last_message, "%s", text);
    if (message_count < MESSAGES_KEPT) {
        snprintf(messages[message_count], MESSAGE_LENGTH, "%s", text);
    }
    ++message_count;
}

uint32_t reference_of(const char *name) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (strcmp(fmu_variables[i].name, name) == 0) {
            return (uint32_t)i;
        }
    }
    fail_msg("there is no variable %s", name);
    return 0;
}
