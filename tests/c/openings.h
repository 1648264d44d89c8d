/* What a finished job is opened to: gaps, growth, solids, rough cracks. */
#ifndef CRAZE_TESTS_C_OPENINGS_H
#define CRAZE_TESTS_C_OPENINGS_H

#include "craze/craze.h"

void cracks_open_and_grow(craze_job* job);

#endif
