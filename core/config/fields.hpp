/// The list of declared fields of a plain struct S, filled by `declare(Fields<S>&)`.
///
/// A member of type std::optional<T> may be absent. A section may be absent when all its fields may.
#pragma once
#include <algorithm>
#include <array>

#include "core/config/field.hpp"

namespace ostium::config {

template <class S>
class Fields;
template <class S>
const Fields<S>& fields();

template <class S>
class Fields {
 public:
  using Names = std::vector<std::string>;
  template <class M>
  using Choices = std::vector<std::pair<std::string, std::type_identity_t<plain_t<M>>>>;

  /// A value with a unit; `unit` is the SI unit it is converted to. M: double or optional<double>.
  template <class M>
  Field<S, M>& quantity(std::string name, M S::*member, std::string unit, std::string doc) {
    return add(
        member,
        {read_quantity, [](double v, const FieldInfo& i) { return write_quantity(v, i.unit); }, one_number},
        {.name = std::move(name),
         .kind = FieldKind::quantity,
         .unit = std::move(unit),
         .doc = std::move(doc)});
  }

  /// The name of a unit, "cm", or a multiple of one; the member holds its size in the SI unit `unit`.
  template <class M>
  Field<S, M>& unit(std::string name, M S::*member, std::string unit, std::string doc) {
    return add(
        member, {read_unit, [](double v, const FieldInfo& i) { return write_quantity(v, i.unit); }},
        {.name = std::move(name), .kind = FieldKind::unit, .unit = std::move(unit), .doc = std::move(doc)});
  }

  /// A number without dimension.
  template <class M>
  Field<S, M>& number(std::string name, M S::*member, std::string doc) {
    return add(member,
               {read_number, [](double v, const FieldInfo&) { return write_quantity(v, ""); }, one_number},
               {.name = std::move(name), .kind = FieldKind::number, .doc = std::move(doc)});
  }

  template <class M>  // M: int or optional<int>
  Field<S, M>& integer(std::string name, M S::*member, std::string doc) {
    using T = plain_t<M>;
    return add(member,
               {[](const Node& n, const FieldInfo& i) { return static_cast<T>(read_integer(n, i)); },
                [](T v, const FieldInfo&) { return Tree::scalar(std::to_string(v)); }},
               {.name = std::move(name),
                .kind = FieldKind::integer,
                .doc = std::move(doc),
                .range = integer_range<T>()});
  }

  template <class M>
  Field<S, M>& text(std::string name, M S::*member, std::string doc) {
    return add(member, {read_text, [](const std::string& v, const FieldInfo&) { return Tree::scalar(v); }},
               {.name = std::move(name), .kind = FieldKind::text, .doc = std::move(doc)});
  }

  template <class M>
  Field<S, M>& flag(std::string name, M S::*member, std::string doc) {
    return add(member,
               {read_flag, [](bool v, const FieldInfo&) { return Tree::scalar(v ? "true" : "false"); }},
               {.name = std::move(name), .kind = FieldKind::flag, .doc = std::move(doc)});
  }

  /// One of several words, each standing for a value.
  template <class M>
  Field<S, M>& choice(std::string name, M S::*member, Choices<M> choices, std::string doc) {
    using T = plain_t<M>;
    FieldInfo info{.name = std::move(name), .kind = FieldKind::choice, .doc = std::move(doc)};
    for (const auto& c : choices) info.choices.push_back(c.first);
    return add(member,
               {[choices](const Node& n, const FieldInfo& i) { return choices[read_choice(n, i)].second; },
                [choices](const T& v, const FieldInfo&) { return Tree::scalar(word_of(v, choices)); }},
               std::move(info));
  }

  /// A file or folder; relative ones refer to the folder of the document.
  template <class M>
  Field<S, M>& path(std::string name, M S::*member, std::string doc) {
    return add(member,
               {read_path, [](const std::filesystem::path& p, const FieldInfo&) { return write_path(p); }},
               {.name = std::move(name), .kind = FieldKind::path, .doc = std::move(doc)});
  }

  /// Values of one unit: [1 mm, 2 mm] or "1 2 mm". M: std::vector<double>, std::array<double, n> or optional
  /// of them.
  template <class M>
  Field<S, M>& list(std::string name, M S::*member, std::string unit, std::string doc) {
    using T = plain_t<M>;
    FieldInfo info{.name = std::move(name),
                   .kind = FieldKind::quantities,
                   .unit = std::move(unit),
                   .doc = std::move(doc)};
    if constexpr (!std::is_same_v<T, std::vector<double>>) info.length = std::tuple_size_v<T>;
    return add(member,
               {[](const Node& n, const FieldInfo& i) { return list_of<T>(read_quantities(n, i)); },
                [](const T& v, const FieldInfo& i) {
                  return write_quantities(std::vector<double>(v.begin(), v.end()), i.unit);
                },
                listed_numbers<T>},
               std::move(info));
  }

  /// A list of words. M: std::vector<std::string>.
  template <class M>
  Field<S, M>& texts(std::string name, M S::*member, std::string doc) {
    return add(member, {read_texts, [](const plain_t<M>& v, const FieldInfo&) { return write_texts(v); }},
               {.name = std::move(name), .kind = FieldKind::texts, .doc = std::move(doc)});
  }

  /// A nested struct with declared fields.
  template <class M>
  Field<S, M>& section(std::string name, M S::*member, std::string doc) {
    using T = plain_t<M>;
    FieldInfo info{.name = std::move(name), .kind = FieldKind::section, .doc = std::move(doc)};
    info.inner = inner_of<T>();
    info.required =
        std::any_of(info.inner->begin(), info.inner->end(), [](const auto& f) { return f.required; });
    return add(member, struct_codec<T>(), std::move(info));
  }

  /// A list of nested structs. The member is std::vector<T>.
  template <class T>
  Field<S, std::vector<T>>& sections(std::string name, std::vector<T> S::*member, std::string doc) {
    FieldInfo info{.name = std::move(name), .kind = FieldKind::sections, .doc = std::move(doc)};
    info.inner = inner_of<T>();
    return add(member, {read_items<T>, write_items<T>}, std::move(info));
  }

  /// Named nested structs in file order. The member is std::vector<std::pair<std::string, T>>.
  template <class T>
  Field<S, std::vector<std::pair<std::string, T>>>& map(std::string name,
                                                        std::vector<std::pair<std::string, T>> S::*member,
                                                        std::string doc) {
    FieldInfo info{.name = std::move(name), .kind = FieldKind::map, .doc = std::move(doc)};
    info.inner = inner_of<T>();
    return add(member, {read_named<T>, write_named<T>}, std::move(info));
  }

  /// A function of time whose values have the SI unit `unit`.
  template <class M>
  Field<S, M>& waveform(std::string name, M S::*member, std::string unit, std::string doc) {
    return add(
        member,
        {[](const Node& n, const FieldInfo& i) { return read_waveform(n, i.unit); },
         [](const Waveform& w, const FieldInfo& i) { return write_waveform(w, i.unit); }, visit_waveform},
        {.name = std::move(name),
         .kind = FieldKind::waveform,
         .unit = std::move(unit),
         .doc = std::move(doc)});
  }

  /// Kept unread for a later reader. M: Node or optional<Node>.
  template <class M>
  Field<S, M>& raw(std::string name, M S::*member, std::string doc) {
    return add(member,
               {[](const Node& n, const FieldInfo&) { return n; },
                [](const Node& n, const FieldInfo&) { return n.tree(); }},
               {.name = std::move(name), .kind = FieldKind::raw, .doc = std::move(doc)});
  }

  /// Keeps the mapping itself, for messages of later checks that should name its position.
  void origin(Node S::*member) {
    keep_origin_ = [member](S& s, const Node& node) { s.*member = node; };
  }

  /// A condition on several fields together: returns the sentence of the error, or nothing.
  void check(std::function<std::string(const S&)> condition) { checks_.push_back(std::move(condition)); }

  S read(const Node& node, const Names& also_allowed) const {
    if (!node.is_map()) require_mapping(node, description());
    if (!node.is_null()) node.check_keys(allowed(also_allowed));
    S s{};
    for (const auto& field : fields_) field->read(s, node);
    if (keep_origin_) keep_origin_(s, node);
    if (const auto sentence = refusal(s); !sentence.empty()) node.error("{}", sentence);
    return s;
  }

  Tree write(const S& s) const {
    Tree mapping = Tree::map();
    for (const auto& field : fields_) field->write(s, mapping);
    return mapping;
  }

  /// Visits the numbers of s in the order of the fields: core/config/numbers.hpp.
  void numbers(S& s, const std::string& prefix, const NumberVisitor& visit) const {
    for (const auto& field : fields_) field->numbers(s, prefix, visit);
  }

  /// The sentence of the first condition that s does not fulfil, or nothing; ranges are not looked at.
  std::string refusal(const S& s) const {
    for (const auto& check : checks_)
      if (auto sentence = check(s); !sentence.empty()) return sentence;
    return {};
  }

  Description description() const {
    Description d;
    for (const auto& field : fields_) d.push_back(field->info);
    return d;
  }

 private:
  template <class M>
  Field<S, M>& add(M S::*member, Codec<plain_t<M>> codec, FieldInfo info) {
    auto field = std::make_shared<Field<S, M>>(member, std::move(codec), std::move(info));
    fields_.push_back(field);
    return *field;
  }

  Names allowed(Names names) const {
    Names all;
    for (const auto& field : fields_) all.push_back(field->info.name);
    all.insert(all.end(), names.begin(), names.end());
    return all;
  }

  template <class T>
  static Range integer_range() {
    if constexpr (sizeof(T) >= sizeof(double))
      return {.low = -0x1p53, .high = 0x1p53};  // doubles count no farther
    return {.low = static_cast<double>(std::numeric_limits<T>::min()),
            .high = static_cast<double>(std::numeric_limits<T>::max())};
  }

  template <class T, class C>
  static std::string word_of(const T& value, const C& choices) {
    for (const auto& c : choices)
      if (c.second == value) return c.first;
    return choices.front().first;
  }

  template <class T>
  static T list_of(const std::vector<double>& v) {
    if constexpr (std::is_same_v<T, std::vector<double>>) {
      return v;
    } else {
      T a{};
      std::copy(v.begin(), v.end(), a.begin());
      return a;
    }
  }

  template <class T>
  static std::shared_ptr<const Description> inner_of() {
    return std::make_shared<Description>(fields<T>().description());
  }

  template <class T>
  static Codec<T> struct_codec() {
    return {[](const Node& n, const FieldInfo&) { return fields<T>().read(n, {}); },
            [](const T& v, const FieldInfo&) { return fields<T>().write(v); },
            [](T& v, const FieldInfo&, const std::string& key, const NumberVisitor& visit) {
              fields<T>().numbers(v, key + ".", visit);
            }};
  }

  static void one_number(double& x, const FieldInfo& info, const std::string& key,
                         const NumberVisitor& visit) {
    visit({key, info.unit, info.range}, x, [&x](double value) { x = value; });
  }
  template <class T>
  static void listed_numbers(T& list, const FieldInfo& info, const std::string& key,
                             const NumberVisitor& visit) {
    for (std::size_t i = 0; i < list.size(); ++i)
      one_number(list[i], info, key + "." + std::to_string(i + 1), visit);
  }

  template <class T>
  static std::vector<T> read_items(const Node& node, const FieldInfo&) {
    std::vector<T> all;
    for (const Node& item : node.items()) all.push_back(fields<T>().read(item, {}));
    return all;
  }
  template <class T>
  static Tree write_items(const std::vector<T>& all, const FieldInfo&) {
    Tree list = Tree::list();
    for (const T& v : all) list.items.push_back(std::make_shared<Tree>(fields<T>().write(v)));
    return list;
  }

  template <class T>
  static std::vector<std::pair<std::string, T>> read_named(const Node& node, const FieldInfo&) {
    std::vector<std::pair<std::string, T>> all;
    for (const auto& [key, item] : node.entries()) all.emplace_back(key, fields<T>().read(item, {}));
    return all;
  }
  template <class T>
  static Tree write_named(const std::vector<std::pair<std::string, T>>& all, const FieldInfo&) {
    Tree mapping = Tree::map();
    for (const auto& [key, v] : all) mapping.add(key, fields<T>().write(v));
    return mapping;
  }

  std::vector<std::shared_ptr<AnyField<S>>> fields_;
  std::vector<std::function<std::string(const S&)>> checks_;
  std::function<void(S&, const Node&)> keep_origin_;
};

}  // namespace ostium::config
