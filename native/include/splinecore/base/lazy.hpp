#pragma once

#include <memory>
#include <mutex>

namespace splinecore {

/// A value that is made when it is first asked for, by whichever thread comes first, and kept from then on.
template <class Value>
class Lazy {
 public:
  /// What make() returns as a std::unique_ptr; if it throws, the next one asks again.
  template <class Make>
  const Value& get(Make make) {
    const std::lock_guard lock(making_);
    if (!value_) value_ = make();
    return *value_;
  }

 private:
  std::mutex making_;
  std::shared_ptr<const Value> value_;
};

}  // namespace splinecore
