#if defined(__x86_64__)
#define SPLINECORE_SET x86_64_v3
#define SPLINECORE_SET_NAME "x86-64-v3"
#include "set.hpp"
#endif
