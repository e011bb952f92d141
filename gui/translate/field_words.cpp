// glint-field-words: writes the names, explanations and choices of all field tables and type lists
// as a source file that lupdate reads, so that the tables stay the one place for them. The editor
// looks them up in the same contexts: see text.h.
#include <cstdio>
#include <set>
#include <string>
#include <type_traits>

#include "tracer/scene/scene.h"

namespace glint {

namespace {

void write(const char* context, std::string_view word) {
    static std::set<std::pair<std::string, std::string>> written;
    if (word.empty() || !written.emplace(context, word).second) return;
    std::printf("QT_TRANSLATE_NOOP(\"%s\", R\"~(%.*s)~\")\n", context,
                static_cast<int>(word.size()), word.data());
}

template <class T>
void writeTable();

template <class T>
void writeMember(const std::type_identity<T>&) {
    if constexpr (requires { T::fields(); }) writeTable<T>();
    if constexpr (std::is_enum_v<T>)
        for (const std::string_view name : enumNames(T{})) write("Field", name);
}
template <class T>
void writeMember(const std::type_identity<std::optional<T>>&) {
    writeMember(std::type_identity<T>());
}
template <class... Ts>
void writeMember(const std::type_identity<std::variant<Ts...>>&) {
    (write("Field", Ts::kind), ...);
    (writeTable<Ts>(), ...);
}

template <class T>
void writeTable() {
    T value{};
    forEachField(value,
                 []<class Member>(std::string_view name, const FieldMeta& meta, const Member&) {
                     write("Field", name);
                     write("FieldDoc", meta.doc);
                     writeMember(std::type_identity<Member>());
                 });
}

}  // namespace

}  // namespace glint

int main() {
    using namespace glint;
    writeTable<Object>();
    writeTable<Group>();
    writeTable<Camera>();
    writeTable<Texture>();
    writeTable<FilmSettings>();
    writeTable<Display>();
    writeTable<RenderSettings>();
    writeTable<Environment>();
    writeMember(std::type_identity<AllMaterials::Variant>());
    writeMember(std::type_identity<AllLights::Variant>());
    writeMember(std::type_identity<AllShapes::Variant>());
}
