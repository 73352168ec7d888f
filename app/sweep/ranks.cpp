#include "app/sweep/ranks.hpp"

#define OMPI_SKIP_MPICXX 1  // the C interface alone: that of C++ needs a library of its own
#include <mpi.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <thread>

#include "core/error.hpp"

namespace ostium::app {
namespace {

/// Of the environment that OpenMPI's launcher, or a batch system in its place, gives each process.
int number(std::initializer_list<const char*> names, int otherwise) {
  for (const char* name : names)
    if (const char* text = std::getenv(name)) return std::atoi(text);
  return otherwise;
}

bool launched() { return number({"OMPI_COMM_WORLD_SIZE"}, 0) > 0 || std::getenv("PMIX_RANK"); }

/// Kind of the error and its text; empty where f does not throw.
std::string failure(const std::function<void()>& f) {
  try {
    f();
    return {};
  } catch (const UserError& e) {
    return std::string("u") + e.what();
  } catch (const NumericsError& e) {
    return std::string("n") + e.what();
  } catch (const std::exception& e) {
    return std::string("b") + e.what();
  }
}

[[noreturn]] void rethrow(const std::string& failure) {
  const std::string text = failure.substr(1);
  if (failure[0] == 'u') throw UserError(text);
  if (failure[0] == 'n') throw NumericsError(text);
  throw Bug(text);
}

}  // namespace

Ranks::Ranks() {
  if (!launched()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  woken_ = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
  if (woken_) MPI_Finalize();
}

void Ranks::each(const std::function<void()>& f) const {
  if (count_ == 1) return f();
  std::string said;
  for (const auto& text : gather(failure(f)))
    if (said.empty()) said = text;
  if (said = from_first(std::move(said)); !said.empty()) rethrow(said);
}

std::int64_t Ranks::from_first(std::int64_t value) const {
  if (count_ > 1) MPI_Bcast(&value, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  return value;
}

std::string Ranks::from_first(std::string text) const {
  text.resize(static_cast<std::size_t>(from_first(static_cast<std::int64_t>(text.size()))));
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

std::vector<std::string> Ranks::gather(const std::string& mine) const {
  if (count_ == 1) return {mine};
  const int size = static_cast<int>(mine.size());
  std::vector<int> sizes(first() ? count_ : 0), begins(sizes.size());
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(sizes.begin(), sizes.end(), begins.begin(), 0);
  std::string joined(first() ? static_cast<std::size_t>(begins.back() + sizes.back()) : 0, '\0');
  MPI_Gatherv(mine.data(), size, MPI_CHAR, joined.data(), sizes.data(), begins.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  std::vector<std::string> all;
  for (std::size_t r = 0; r < sizes.size(); ++r)
    all.push_back(joined.substr(static_cast<std::size_t>(begins[r]), static_cast<std::size_t>(sizes[r])));
  return all;
}

bool is_first_process() { return number({"OMPI_COMM_WORLD_RANK", "PMIX_RANK"}, 0) == 0; }

int share_of_cores() {
  const int all = static_cast<int>(std::thread::hardware_concurrency()), ours = omp_get_max_threads();
  const bool chosen = std::getenv("OMP_NUM_THREADS") || ours < all;  // by the user, or by binding to cores
  return chosen ? ours : std::max(1, all / number({"OMPI_COMM_WORLD_LOCAL_SIZE"}, 1));
}

}  // namespace ostium::app
