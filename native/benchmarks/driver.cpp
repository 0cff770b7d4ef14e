#include "driver.hpp"

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace benchmarks {

namespace {

constexpr double kSeconds = 0.4;
constexpr std::size_t kFewest = 3;
constexpr std::size_t kMost = 200;

/// Of the processor, all threads together: what else runs on the machine does not count.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median_seconds(const std::function<void()>& prepare, const std::function<void()>& work) {
  Numbers times;
  double spent = 0;
  prepare();
  work();
  while (times.size() < kFewest || (times.size() < kMost && spent < kSeconds)) {
    prepare();
    const double start = now();
    work();
    times.push_back(now() - start);
    spent += times.back();
  }
  std::ranges::sort(times);
  return times[times.size() / 2];
}

}  // namespace

Run::Run(std::string data, std::string kept, std::string rival, std::string workload)
    : data_(std::move(data)), kept_(std::move(kept)), rival_(std::move(rival)), workload_(std::move(workload)) {}

Numbers Run::input(const std::string& name) const {
  const std::string path = data_ + "/" + name + ".f64";
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + path);
  Numbers numbers(std::filesystem::file_size(path) / sizeof(double));
  file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

void Run::time(const std::string& call, std::size_t items, const std::function<void()>& work,
               const std::string& note) const {
  time(call, items, [] {}, work, note);
}

void Run::time(const std::string& call, std::size_t items, const std::function<void()>& prepare,
               const std::function<void()>& work, const std::string& note) const {
  const double seconds = median_seconds(prepare, work);
  std::printf(R"({"workload": "%s", "who": "%s", "call": "%s", "seconds": %.9g, "items": %zu, "note": "%s"})"
              "\n",
              workload_.c_str(), rival_.c_str(), call.c_str(), seconds, items, note.c_str());
}

void Run::keep(const std::string& call, std::size_t count, std::size_t columns, const Row& row,
               std::size_t step) const {
  std::ofstream file(kept_ + "/" + workload_ + "." + rival_ + "." + call + ".f64", std::ios::binary);
  for (std::size_t i = 0; i < count; i += step) {
    file.write(reinterpret_cast<const char*>(row(i)), static_cast<std::streamsize>(columns * sizeof(double)));
  }
}

int drive(int argc, char** argv, const std::string& rival, const Workloads& workloads) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s DATA KEPT WORKLOAD\n", argv[0]);
    return 2;
  }
  const auto found = workloads.find(argv[3]);
  if (found == workloads.end()) return 0;
  try {
    found->second(Run(argv[1], argv[2], rival, argv[3]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s, %s: %s\n", rival.c_str(), argv[3], error.what());
    return 1;
  }
  return 0;
}

}  // namespace benchmarks
