#if defined(__x86_64__)
#define SPLINECORE_SET x86_64_v4
#define SPLINECORE_SET_NAME "x86-64-v4"
#include "set.hpp"
#endif
