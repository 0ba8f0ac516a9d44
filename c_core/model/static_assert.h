/* Assertions that the compiler checks: C99 has none of its own, but no array of negative size either. */
#ifndef TDMF_MODEL_STATIC_ASSERT_H
#define TDMF_MODEL_STATIC_ASSERT_H

/* At file scope; `name` says what holds, and is in the compiler's message where it does not. */
#define TDMF_STATIC_ASSERT(condition, name) typedef char tdmf_assert_##name[(condition) ? 1 : -1]

#endif
