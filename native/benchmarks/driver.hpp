#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

// What the programs that time a rival share: the inputs, the clock, what they say.
namespace benchmarks {

using Numbers = std::vector<double>;

inline constexpr std::size_t kSampleStep = 2503;

/// Row i of a result, three numbers or more.
using Row = std::function<const double*(std::size_t)>;

/// One workload that one program runs: DATA is the folder of inputs, KEPT of results.
class Run {
 public:
  Run(std::string data, std::string kept, std::string rival, std::string workload);

  [[nodiscard]] Numbers input(const std::string& name) const;

  /// Prints the median of the seconds that `work` takes, after a first time that does not count.
  void time(const std::string& call, std::size_t items, const std::function<void()>& work,
            const std::string& note = "") const;

  /// The same, `prepare` outside the clock.
  void time(const std::string& call, std::size_t items, const std::function<void()>& prepare,
            const std::function<void()>& work, const std::string& note = "") const;

  /// Writes every `step`-th of `count` rows of `columns` numbers, to be held against exact ones.
  void keep(const std::string& call, std::size_t count, std::size_t columns, const Row& row,
            std::size_t step = kSampleStep) const;

 private:
  std::string data_;
  std::string kept_;
  std::string rival_;
  std::string workload_;
};

using Workloads = std::map<std::string, std::function<void(const Run&)>>;

/// PROGRAM DATA KEPT WORKLOAD: runs the workload if the rival has it.
int drive(int argc, char** argv, const std::string& rival, const Workloads& workloads);

}  // namespace benchmarks
