#include "gui/panels/item_forms.h"

#include <set>

#include "gui/app/item.h"
#include "tracer/scene/edit.h"

namespace glint {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ItemForms)
};

QString reasonFor(NameFault fault) {
    switch (fault) {
        case NameFault::None:
            return {};
        case NameFault::Empty:
            return Text::tr("A name must not be empty");
        case NameFault::Taken:
            return Text::tr("Another one has this name");
        case NameFault::Fixed:
            return Text::tr("This one has no name of its own");
    }
    return {};
}

/// The name of items of one kind; refuses what files could not tell apart.
Lens<std::string> itemName(ItemKind kind, const Lens<std::string>& plain) {
    return {plain.get, [kind, plain](Scene& scene, std::uint32_t target, const std::string& name) {
                const NameFault fault = nameFault(scene, {kind, target}, name);
                return fault == NameFault::None ? plain.set(scene, target, name) : reasonFor(fault);
            }};
}

/// The group that holds an item; setting it keeps the item's place in the world.
Lens<GroupId> itemParent(ItemKind kind, const Lens<GroupId>& plain) {
    return {plain.get, [kind](Scene& scene, std::uint32_t target, const GroupId& parent) {
                scene = movedInto(std::move(scene), {kind, target}, parent);
                return QString();
            }};
}

void addName(FormBuilder& form, Section* section, const QString& path, const FieldMeta& meta,
             const Lens<std::string>& lens) {
    // Names are unique, so one cannot be given to several, nor reset.
    FieldBinding<std::string> binding = form.bind<std::string>(lens, path, "name", meta, {});
    if (form.targets()->size() > 1)
        binding.lens.get = [](const Scene&, std::uint32_t) { return nullptr; };
    const FieldEditor editor = makeEditor(binding, section);
    form.placeRow(section, binding.label, meta, editor, {});
}

/// One row of an item's own section: name and parent get their special lenses, nested parts wait
/// for their sections.
template <class Owner, class Member>
void addItemField(FormBuilder& form, Section* section, ItemKind kind, const QString& path,
                  const Lens<Owner>& lens, const Field<Owner, Member>& field,
                  const Owner& initial) {
    const Lens<Member> member = memberOf(lens, field.member);
    if constexpr (std::is_same_v<Member, std::string>) {
        if (field.name == "name")
            return addName(form, section, path, field.meta, itemName(kind, member));
    }
    if constexpr (std::is_same_v<Member, GroupId>)
        form.addRow(section, form.bind(itemParent(kind, member), path, field.name, field.meta,
                                       initial.*field.member));
    else if constexpr (!HasFields<Member> && !kIsVariant<Member>)
        form.addRow(section,
                    form.bind(member, path, field.name, field.meta, initial.*field.member));
}

template <class Owner>
void addItemSection(FormBuilder& form, const QString& title, ItemKind kind, const QString& path,
                    const Lens<Owner>& lens) {
    Section* section = form.addSection(title);
    const Owner initial{};
    std::apply(
        [&](const auto&... field) {
            (addItemField(form, section, kind, path, lens, field, initial), ...);
        },
        Owner::fields());
}

/// Changes the type of all targets to the default value of `kind`.
template <class List, class Variant = typename List::Variant>
std::function<QString(std::string_view)> kindChanger(const FormBuilder& form,
                                                     const Lens<Variant>& lens,
                                                     const QString& text) {
    const FieldBinding<Variant> binding{&form.document(), lens, form.targets(), {}, text, {}, {}};
    return [binding](std::string_view kind) {
        QString reason;
        List::withKind(kind, [&](const auto& value) { reason = binding.edit(Variant(value)); });
        return reason;
    };
}

/// As kindChanger, but a material that becomes a mix keeps its look as part a, with "clear" as part
/// b.
std::function<QString(std::string_view)> materialChanger(const FormBuilder& form,
                                                         const Lens<AllMaterials::Variant>& lens) {
    Document* document = &form.document();
    const Targets targets = form.targets();
    const auto plain = kindChanger<AllMaterials>(form, lens, Text::tr("Material type"));
    return [document, targets, plain](std::string_view kind) {
        if (kind != Mix::kind) return plain(kind);
        Scene scene = document->committed();
        for (const std::uint32_t target : *targets) {
            Material material = scene.materials.at(MaterialId{target});
            if (kindOf(material.value) == kind) continue;
            auto [next, part] =
                withMaterial(std::move(scene), Material{material.name + " part", material.value});
            scene = std::move(next);
            material.value = Mix{MixPart{part, false}, MixPart{{}, true}, 0.5};
            scene.materials.set(MaterialId{target}, std::move(material));
        }
        document->edit(std::move(scene), Text::tr("Change material type"));
        return QString();
    };
}

template <class Visit>
void forEachTexture(const AllMaterials::Variant& material, Visit&& visit) {
    std::visit(
        [&](const auto& m) {
            forEachField(m, [&](std::string_view, const FieldMeta&, const auto& value) {
                if constexpr (requires { value.texture; })
                    if (value.texture) visit(value.texture);
            });
        },
        material);
}

}  // namespace

std::vector<std::uint32_t> materialsOf(const Scene& scene,
                                       const std::vector<std::uint32_t>& objects) {
    std::set<std::uint32_t> out;
    for (const std::uint32_t id : objects)
        if (const MaterialId material = scene.objects.at(ObjectId{id}).material)
            out.insert(material.value);
    return {out.begin(), out.end()};
}

std::vector<std::uint32_t> texturesOf(const Scene& scene,
                                      const std::vector<std::uint32_t>& materials) {
    std::set<std::uint32_t> out;
    for (const std::uint32_t id : materials)
        forEachTexture(scene.materials.at(MaterialId{id}).value,
                       [&](TextureId texture) { out.insert(texture.value); });
    return {out.begin(), out.end()};
}

void buildObjectForm(FormBuilder& form) {
    const Lens<Object> object = entryOf(&Scene::objects);
    addItemSection(form, Text::tr("Object"), ItemKind::Object, "object", object);
    form.addStruct(Text::tr("Transform"), "object.transform", memberOf(object, &Object::transform));
    const Lens<Shape> shape = memberOf(object, &Object::shape);
    form.addVariant<AllShapes>(Text::tr("Shape"), "object.shape", shape,
                               kindChanger<AllShapes>(form, shape, Text::tr("Shape")));
}

void buildGroupForm(FormBuilder& form) {
    const Lens<Group> group = entryOf(&Scene::groups);
    addItemSection(form, Text::tr("Group"), ItemKind::Group, "group", group);
    form.addStruct(Text::tr("Transform"), "group.transform", memberOf(group, &Group::transform));
}

void buildLightForm(FormBuilder& form) {
    const Lens<Light> light = entryOf(&Scene::lights);
    Section* section = form.addSection(Text::tr("Light"));
    addName(form, section, "light", {.doc = "Unique name"},
            itemName(ItemKind::Light, memberOf(light, &Light::name)));
    form.addRow(section, form.bind(memberOf(light, &Light::visible), "light", "visible",
                                   {.doc = "Part of the picture"}, true));
    form.addRow(section,
                form.bind<std::string>(memberOf(light, &Light::lightGroup), "light", "light_group",
                                       {.doc = "Group of lights it belongs to"}, {}));
    const Lens<AllLights::Variant> value = memberOf(light, &Light::value);
    form.addVariant<AllLights>(Text::tr("Emission"), "light", value,
                               kindChanger<AllLights>(form, value, Text::tr("Light type")));
}

void buildCameraForm(FormBuilder& form) {
    const Lens<Camera> named = entryOf(&Scene::cameras), own = partOf(&Scene::camera);
    const Lens<Camera> camera{[=](const Scene& scene, std::uint32_t id) {
                                  return id ? named.get(scene, id) : own.get(scene, id);
                              },
                              [=](Scene& scene, std::uint32_t id, const Camera& value) {
                                  return id ? named.set(scene, id, value)
                                            : own.set(scene, id, value);
                              }};
    addItemSection(form, Text::tr("Camera"), ItemKind::Camera, "camera", camera);
}

void buildMaterialForm(FormBuilder& form) {
    const Lens<Material> material = entryOf(&Scene::materials);
    const Lens<AllMaterials::Variant> value = memberOf(material, &Material::value);
    Section* section = form.addSection(Text::tr("Material"));
    const Lens<std::string> plain = memberOf(material, &Material::name);
    addName(form, section, "material", {.doc = "Unique name"},
            {plain.get,
             [plain](Scene& scene, std::uint32_t target, const std::string& name) -> QString {
                 if (name.empty()) return reasonFor(NameFault::Empty);
                 const bool same = scene.materials.at(MaterialId{target}).name == name;
                 if (!same && freeMaterialName(scene, name) != name)
                     return reasonFor(NameFault::Taken);
                 return plain.set(scene, target, name);
             }});
    form.addVariantRows<AllMaterials>(section, "material", value, materialChanger(form, value));
}

void buildTextureForm(FormBuilder& form) {
    form.addStruct(Text::tr("Texture"), "texture", entryOf(&Scene::textures));
}

}  // namespace glint
