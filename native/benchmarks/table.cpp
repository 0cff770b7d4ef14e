#include "table.hpp"

#include <cstdio>

namespace benchmarks {

bool RatioTable::ReportContext(const Context&) { return true; }

void RatioTable::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred || (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median")) continue;
    const std::string name = run.run_name.function_name;
    const auto slash = name.rfind('/');
    const auto items = run.counters.find("items_per_second");
    if (items != run.counters.end()) nanoseconds_[name.substr(0, slash)][name.substr(slash + 1)] = 1e9 / items->second;
  }
}

void RatioTable::Finalize() {
  std::printf("%-28s%14s%14s%10s\n", "ns an item, median", "splinecore", "SISL", "ratio");
  for (auto& [workload, times] : nanoseconds_) {
    std::printf("%-28s%14.2f%14.2f%9.1fx\n", workload.c_str(), times["splinecore"], times["SISL"],
                times["SISL"] / times["splinecore"]);
  }
}

}  // namespace benchmarks
