// Field tables: one description of each document field, from which come JSON, schema, property
// panel, undo text and `--set`. A struct lists its fields in `static constexpr auto fields()`; walk
// them with forEachField().
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

namespace glint {

/// What a person may enter in a field, and how it is explained to them.
struct FieldMeta {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool exclusiveMin = false;  ///< min itself is not allowed
    bool required = false;      ///< must stand in a file
    std::string_view unit = "";
    std::string_view doc = "";
};

/// One field of `Owner`: the key in the file, the member, and its meta data.
template <class Owner, class Member>
struct Field {
    std::string_view name;
    Member Owner::*member;
    FieldMeta meta;

    constexpr Field(std::string_view n, Member Owner::*m, FieldMeta d = {})
        : name(n), member(m), meta(d) {}
};

/// Calls `visit(name, meta, value.*member)` for each field in table order.
template <class T, class Visit>
constexpr void forEachField(T& value, Visit&& visit) {
    std::apply(
        [&](const auto&... field) { (visit(field.name, field.meta, value.*field.member), ...); },
        std::remove_const_t<T>::fields());
}

/// A closed list of types; `Variant` holds any one of them. Each type has a `kind`, its name in a
/// file.
template <class... Ts>
struct TypeList {
    using Variant = std::variant<Ts...>;
    static constexpr std::array<std::string_view, sizeof...(Ts)> kinds = {Ts::kind...};

    /// Calls `visit(T{})` with a default value of the type whose kind is `kind`; false if there is
    /// none.
    template <class Visit>
    static constexpr bool withKind(std::string_view kind, Visit&& visit) {
        return ((Ts::kind == kind ? (visit(Ts{}), true) : false) || ...);
    }
    /// Calls `visit(T{})` for each type in list order.
    template <class Visit>
    static constexpr void forEach(Visit&& visit) {
        (visit(Ts{}), ...);
    }
};

/// The kind of the alternative that a variant holds.
template <class... Ts>
[[nodiscard]] constexpr std::string_view kindOf(const std::variant<Ts...>& v) {
    return std::visit([](const auto& x) { return std::remove_cvref_t<decltype(x)>::kind; }, v);
}

}  // namespace glint
