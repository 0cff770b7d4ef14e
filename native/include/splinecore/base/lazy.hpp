#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace splinecore {

/// A value that is made when it is first asked for, and kept from then on.
template <class Value>
class Lazy {
 public:
  /// What make() returned first as a std::unique_ptr. Threads that come meanwhile make it, too: none waits, as it might for
  /// what itself calls this.
  template <class Make>
  const Value& get(Make make) {
    {
      const std::lock_guard lock(keeping_);
      if (value_) return *value_;
    }
    std::shared_ptr<const Value> made = make();
    const std::lock_guard lock(keeping_);
    if (!value_) value_ = std::move(made);
    return *value_;
  }

 private:
  std::mutex keeping_;
  std::shared_ptr<const Value> value_;
};

}  // namespace splinecore
