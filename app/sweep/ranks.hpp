/// The processes of a sweep: this one alone, or all that mpirun has started.
///
/// MPI is woken only where mpirun has started the program: without it nothing of MPI is run, nor needs to be set up.
/// All processes call the same functions in the same order; the first one reads and writes files and talks.
/// Source: docs/decisions/0019-sweeps-under-mpi.md. Not checked: that all processes see the same files.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ostium::app {

class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool first() const { return rank_ == 0; }

  /// Runs f in each process. Where it throws in one of them all throw that error, so that nobody waits for ever.
  void each(const std::function<void()>& f) const;
  /// The first process's value.
  std::int64_t from_first(std::int64_t value) const;
  /// In the first process what each has given, in their order; elsewhere nothing.
  std::vector<std::string> gather(const std::string& mine) const;

 private:
  std::string from_first(std::string text) const;

  int rank_ = 0, count_ = 1;
  bool woken_ = false;
};

/// Whether this process is the one that talks; known without MPI.
bool is_first_process();

/// How many threads this process should have where nobody says: its share of the machine's cores.
int share_of_cores();

}  // namespace ostium::app
