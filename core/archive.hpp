/// Plain state as named arrays of numbers: one description of a structure serves writing and reading.
///
///   void archive(Archive& a, State& s) {      // found by argument-dependent lookup
///     a("time", s.time);
///     a("y", s.y);
///   }
///
/// Who derives from it decides where the arrays go. Reading throws UserError where a name is missing, of another kind or of
/// another length than a single number has. Not checked: what the numbers mean.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace ostium {

class Archive {
 public:
  virtual ~Archive() = default;
  virtual bool reading() const = 0;
  /// Throws: what stands under this name is not what is wanted.
  [[noreturn]] virtual void misfit(const std::string& name, const std::string& problem) const = 0;

  void operator()(const std::string& name, double& x);
  void operator()(const std::string& name, std::int64_t& x);
  void operator()(const std::string& name, bool& x);
  void operator()(const std::string& name, std::string& x);
  void operator()(const std::string& name, std::vector<double>& x) { records<double>(name, x); }
  void operator()(const std::string& name, std::vector<std::int64_t>& x) { records<std::int64_t>(name, x); }
  void operator()(const std::string& name, std::vector<std::uint8_t>& x) { records<std::uint8_t>(name, x); }
  void operator()(const std::string& name, std::vector<std::string>& x) {
    list(name, x, [&](std::string& text) { (*this)("text", text); });
  }

  /// Structures that are nothing but numbers of one kind, as they lie in memory.
  template <class Number, class Record>
  void records(const std::string& name, std::vector<Record>& x) {
    static_assert(sizeof(Record) % sizeof(Number) == 0);
    array(name, kind_of<Number>(), x.size(), sizeof(Record) / sizeof(Number), [&](std::size_t n) {
      x.resize(n);
      return static_cast<void*>(x.data());
    });
  }

  /// f() describes what stands under this name.
  template <class F>
  void part(const std::string& name, F f) {
    enter(name);
    f();
    leave();
  }

  /// each(item) describes an item.
  template <class T, class F>
  void list(const std::string& name, std::vector<T>& items, F each) {
    part(name, [&] {
      auto n = static_cast<std::int64_t>(items.size());
      (*this)("count", n);
      items.resize(static_cast<std::size_t>(n));
      for (std::size_t i = 0; i < items.size(); ++i) part(std::to_string(i), [&] { each(items[i]); });
    });
  }

 protected:
  enum class Kind { real, single, integer, byte };
  /// Where the numbers of so many records are or shall be.
  using Place = std::function<void*(std::size_t records)>;

  virtual void array(const std::string& name, Kind kind, std::size_t records, std::size_t per_record,
                     const Place& place) = 0;
  virtual void enter(const std::string& name) = 0;
  virtual void leave() = 0;

 private:
  template <class Number>
  static constexpr Kind kind_of() {
    if constexpr (std::is_same_v<Number, double>) return Kind::real;
    if constexpr (std::is_same_v<Number, float>) return Kind::single;
    if constexpr (std::is_same_v<Number, std::int64_t>) return Kind::integer;
    if constexpr (std::is_same_v<Number, std::uint8_t>) return Kind::byte;
  }
  void one(const std::string& name, Kind kind, void* number);
};

}  // namespace ostium
