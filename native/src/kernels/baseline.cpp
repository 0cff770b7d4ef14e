#define SPLINECORE_SET baseline
#define SPLINECORE_SET_NAME "baseline"
#include "set.hpp"
