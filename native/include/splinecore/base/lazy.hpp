#pragma once

#include <atomic>
#include <memory>

namespace splinecore {

/// A value that is made when it is first asked for, and kept from then on.
template <class Value>
class Lazy {
 public:
  Lazy() = default;
  ~Lazy() { delete kept_.load(); }
  Lazy(const Lazy&) = delete;
  Lazy& operator=(const Lazy&) = delete;

  /// The value, which make() returns as a std::unique_ptr. Of threads that come at once each makes it and the first to be
  /// done is kept: none waits, as it might for what itself calls this.
  template <class Make>
  const Value& get(Make make) {
    const Kept* known = kept_.load(std::memory_order_acquire);
    if (known != nullptr) return **known;
    auto made = std::make_unique<const Kept>(make());
    if (kept_.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) known = made.release();
    return **known;
  }

 private:
  using Kept = std::shared_ptr<const Value>;  // which ends a value of a type that is not known here

  std::atomic<const Kept*> kept_{nullptr};
};

}  // namespace splinecore
