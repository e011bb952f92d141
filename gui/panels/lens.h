// Lens<T>: where a value of type T stands in a scene, for one of many targets given by number. The
// property panel is made of lenses: roots (an object, the film, ...) composed with the members that
// field tables name.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "tracer/scene/scene.h"

namespace glint {

template <class T>
struct Lens {
    /// Null where the target has no such value.
    std::function<const T*(const Scene&, std::uint32_t)> get;
    /// Why the value was refused, or empty when it is set.
    std::function<QString(Scene&, std::uint32_t, const T&)> set;
};

/// A member of a struct.
template <class Owner, class T>
[[nodiscard]] Lens<T> memberOf(const Lens<Owner>& owner, T Owner::*member) {
    return {[owner, member](const Scene& scene, std::uint32_t target) -> const T* {
                const Owner* found = owner.get(scene, target);
                return found ? &(found->*member) : nullptr;
            },
            [owner, member](Scene& scene, std::uint32_t target, const T& value) -> QString {
                const Owner* found = owner.get(scene, target);
                if (!found) return {};
                Owner changed = *found;
                changed.*member = value;
                return owner.set(scene, target, changed);
            }};
}

/// The alternative T of a variant; none where it holds another.
template <class T, class Variant>
[[nodiscard]] Lens<T> alternativeOf(const Lens<Variant>& owner) {
    return {[owner](const Scene& scene, std::uint32_t target) -> const T* {
                const Variant* found = owner.get(scene, target);
                return found ? std::get_if<T>(found) : nullptr;
            },
            [owner](Scene& scene, std::uint32_t target, const T& value) {
                return owner.set(scene, target, Variant(value));
            }};
}

/// The value of an optional; none where it is empty.
template <class T>
[[nodiscard]] Lens<T> contentOf(const Lens<std::optional<T>>& owner) {
    return {[owner](const Scene& scene, std::uint32_t target) -> const T* {
                const std::optional<T>* found = owner.get(scene, target);
                return found && *found ? &**found : nullptr;
            },
            [owner](Scene& scene, std::uint32_t target, const T& value) {
                return owner.set(scene, target, value);
            }};
}

/// One component of a vector or array.
template <class Vector>
[[nodiscard]] Lens<double> componentOf(const Lens<Vector>& owner, std::size_t index) {
    using Index = std::conditional_t < requires(Vector v) { v.size(); }
    , std::size_t, int > ;
    const auto i = static_cast<Index>(index);
    return {[owner, i](const Scene& scene, std::uint32_t target) -> const double* {
                const Vector* found = owner.get(scene, target);
                return found ? &(*found)[i] : nullptr;
            },
            [owner, i](Scene& scene, std::uint32_t target, const double& value) -> QString {
                const Vector* found = owner.get(scene, target);
                if (!found) return {};
                Vector changed = *found;
                changed[i] = value;
                return owner.set(scene, target, changed);
            }};
}

/// An entry of one of the scene's tables.
template <class T, class IdType>
[[nodiscard]] Lens<T> entryOf(Table<T, IdType> Scene::*table) {
    return {[table](const Scene& scene, std::uint32_t target) {
                return (scene.*table).find(IdType{target});
            },
            [table](Scene& scene, std::uint32_t target, const T& value) {
                (scene.*table).set(IdType{target}, value);
                return QString();
            }};
}

/// A part of the scene that stands there once.
template <class T>
[[nodiscard]] Lens<T> partOf(T Scene::*part) {
    return {[part](const Scene& scene, std::uint32_t) { return &(scene.*part); },
            [part](Scene& scene, std::uint32_t, const T& value) {
                scene.*part = value;
                return QString();
            }};
}

}  // namespace glint
