#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace benchmarks {

/// Collects runs named "WORKLOAD/splinecore" and "WORKLOAD/SISL" and prints, at the end, nanoseconds
/// per item of both and how many times faster the first is.
class RatioTable : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::map<std::string, std::map<std::string, double>> nanoseconds_;
};

}  // namespace benchmarks
