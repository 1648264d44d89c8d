/* What the program of this folder expects, counted. */
#ifndef CRAZE_TESTS_C_EXPECT_H
#define CRAZE_TESTS_C_EXPECT_H

#include <stdio.h>
#include <string.h>

extern int failures;

#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                             \
    }                                                                         \
  } while (0)

/* The call failed as it should, and said so in one line. */
#define EXPECT_ERROR(call, wanted)               \
  do {                                           \
    craze_error error;                           \
    craze_error* e = &error;                     \
    memset(e, 0, sizeof error);                  \
    (void)(call);                                \
    EXPECT(error.status == (wanted));            \
    EXPECT(strlen(error.message) > 0);           \
    EXPECT(strchr(error.message, '\n') == NULL); \
  } while (0)

#endif
