#if defined(__x86_64__)
#define SPLINECORE_SET x86_64_v3
#include "set.hpp"
#endif
