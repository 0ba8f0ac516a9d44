#include "test.h"

int main(void) {
    return run_registered_tests();
}
