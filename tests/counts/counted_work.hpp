#pragma once

#include <functional>

/// What runs inside is counted. In a file of its own, or the compiler would make copies of other names.
extern "C" void counted_work(const std::function<void()>& work);
