#include "tracer/io/material_graph.h"

#include <algorithm>

#include "tracer/io/scene_check.h"

namespace glint {

namespace {

/// Depth first with a stack of its own, so that a long chain of mixes cannot overflow the
/// program's.
class Walk {
  public:
    explicit Walk(const Scene& scene) : scene_(scene) {}

    MaterialGraph run() {
        scene_.materials.forEach([&](MaterialId id, const Material&) { visit(id); });
        return std::move(graph_);
    }

  private:
    enum class State { New, Open, Done };
    struct Step {
        MaterialId id;
        int nextPart = 0;
    };

    void visit(MaterialId root) {
        if (state_[root.value] != State::New) return;
        open(root);
        while (!steps_.empty()) {
            Step& step = steps_.back();
            const auto* mix = std::get_if<Mix>(&scene_.materials.at(step.id).value);
            if (!mix || step.nextPart == 2) {
                close(step.id, mix);
                continue;
            }
            const MaterialId part = (step.nextPart++ == 0 ? mix->a : mix->b).material;
            if (!scene_.materials.find(part)) continue;
            if (state_[part.value] == State::Open && !closes(step.id))
                graph_.closingCycle.push_back(step.id);
            if (state_[part.value] == State::New) open(part);
        }
    }

    void open(MaterialId id) {
        state_[id.value] = State::Open;
        steps_.push_back({id});
    }

    void close(MaterialId id, const Mix* mix) {
        MaterialContent content;
        if (mix) {
            const MaterialContent a = of(mix->a), b = of(mix->b);
            content = {std::min(a.leaves + b.leaves, kMaxMixLeaves + 1),
                       a.solidGlass || b.solidGlass};
        } else if (const auto* glass = std::get_if<Glass>(&scene_.materials.at(id).value)) {
            content.solidGlass = !glass->thin;
        }
        graph_.content[id.value] = content;
        state_[id.value] = State::Done;
        steps_.pop_back();
    }

    [[nodiscard]] MaterialContent of(const MixPart& part) const {
        const auto found = graph_.content.find(part.material.value);
        return found == graph_.content.end() ? MaterialContent{} : found->second;
    }

    [[nodiscard]] bool closes(MaterialId id) const {
        return !graph_.closingCycle.empty() && graph_.closingCycle.back() == id;
    }

    const Scene& scene_;
    std::unordered_map<std::uint32_t, State> state_;
    std::vector<Step> steps_;
    MaterialGraph graph_;
};

}  // namespace

MaterialGraph materialGraph(const Scene& scene) { return Walk(scene).run(); }

}  // namespace glint
