/// One declared field of a struct S: its description, and how its value is read, defaulted and written.
#pragma once
#include <functional>
#include <optional>
#include <type_traits>

#include "core/config/info.hpp"
#include "core/config/numbers.hpp"
#include "core/config/values.hpp"

namespace ostium::config {

template <class T>
struct Codec {
  std::function<T(const Node&, const FieldInfo&)> read;
  std::function<Tree(const T&, const FieldInfo&)> write;
  /// Visits the numbers in it, those of a value of several under the key of the field; nothing: it holds none.
  std::function<void(T&, const FieldInfo&, const std::string& key, const NumberVisitor&)> numbers = {};
};

template <class M>
struct PlainType {
  using type = M;
  static constexpr bool optional = false;
};
template <class T>
struct PlainType<std::optional<T>> {
  using type = T;
  static constexpr bool optional = true;
};
template <class M>
using plain_t = typename PlainType<M>::type;

template <class S>
struct AnyField {
  FieldInfo info;
  virtual ~AnyField() = default;
  virtual void read(S& s, const Node& mapping) const = 0;
  virtual void write(const S& s, Tree& mapping) const = 0;
  virtual void numbers(S& s, const std::string& prefix, const NumberVisitor& visit) const = 0;
};

/// M is the member's type: T, or std::optional<T> for a value that may be absent.
template <class S, class M>
class Field final : public AnyField<S> {
 public:
  using T = plain_t<M>;

  Field(M S::*member, Codec<T> codec, FieldInfo declared) : member_(member), codec_(std::move(codec)) {
    this->info = std::move(declared);
    if (PlainType<M>::optional) this->info.required = false;
  }

  Field& or_else(T value) {
    this->info.required = false;
    this->info.fallback = to_text(codec_.write(value, this->info));
    fallback_ = std::move(value);
    return *this;
  }
  /// Must be given, even if nothing in it must.
  Field& required() {
    this->info.required = true;
    return *this;
  }
  Field& positive() { return above(0); }
  Field& non_negative() { return at_least(0); }
  Field& above(double x) { return low(x, true); }
  Field& at_least(double x) { return low(x, false); }
  Field& below(double x) { return high(x, true); }
  Field& at_most(double x) { return high(x, false); }

  void read(S& s, const Node& mapping) const override {
    if (auto node = mapping.is_null() ? std::nullopt : mapping.find(this->info.name))
      s.*member_ = codec_.read(*node, this->info);
    else if (fallback_)
      s.*member_ = *fallback_;
    else if (this->info.required)
      missing_key(mapping, this->info);
    else if constexpr (!PlainType<M>::optional)  // a section whose fields all have defaults
      s.*member_ = codec_.read(Node(), this->info);
  }

  void write(const S& s, Tree& mapping) const override {
    const M& value = s.*member_;
    if constexpr (PlainType<M>::optional) {
      if (value) mapping.add(this->info.name, codec_.write(*value, this->info));
    } else {
      mapping.add(this->info.name, codec_.write(value, this->info));
    }
  }

  void numbers(S& s, const std::string& prefix, const NumberVisitor& visit) const override {
    if (!codec_.numbers) return;
    M& value = s.*member_;
    if constexpr (PlainType<M>::optional) {
      if (value) codec_.numbers(*value, this->info, prefix + this->info.name, visit);
    } else {
      codec_.numbers(value, this->info, prefix + this->info.name, visit);
    }
  }

 private:
  Field& low(double x, bool open) {
    this->info.range.low = x, this->info.range.low_open = open;
    return *this;
  }
  Field& high(double x, bool open) {
    this->info.range.high = x, this->info.range.high_open = open;
    return *this;
  }

  M S::*member_;
  Codec<T> codec_;
  std::optional<T> fallback_;
};

}  // namespace ostium::config
