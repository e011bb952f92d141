#include <chrono>

#include "tests/bench/clock.h"
#include "tests/bench/peers/renderers.h"
#include "tracer/compile/compiler.h"
#include "tracer/compile/render_scene.h"
#include "tracer/render/render.h"

namespace glint::bench {

namespace {

class InProcess final : public GlintRenderer {
  public:
    InProcess(PeerScene peer, double setupSeconds)
        : peer_(std::move(peer)), setupSeconds_(setupSeconds) {}

    Status prepare() {
        const Stopwatch watch;
        Result<Compiled> compiled = compile(peer_.scene, peer_.folder, assets_);
        if (!compiled) return compiled.error();
        compiled_ = compiled.value().scene;
        for (const CompileWarning& warning : compiled.value().warnings)
            notes_.push_back(warning.error.text());
        setupSeconds_ += watch.wallSeconds();
        return Done{};
    }
    Result<TimedPicture> render(int spp, int seed) override { return timed(spp, 0, seed); }
    Result<TimedPicture> renderTo(double errorPercent, int seed) override {
        return timed(kMostSpp, errorPercent, seed);
    }
    [[nodiscard]] double setupSeconds() const override { return setupSeconds_; }
    [[nodiscard]] std::vector<std::string> notes() const override { return notes_; }

  private:
    static constexpr int kMostSpp = 1 << 16;

    TimedPicture timed(int spp, double errorPercent, int seed) {
        auto scene = std::make_shared<RenderScene>(*compiled_);
        scene->settings.spp = spp;
        scene->settings.errorPercent = errorPercent;
        scene->settings.seed = seed;
        const Stopwatch watch;
        Rendering rendering = glint::render(scene, {.threads = peer_.threads});
        return {std::move(rendering.beauty), rendering.seconds, watch.processSeconds()};
    }

    PeerScene peer_;
    AssetCache assets_;
    std::shared_ptr<const RenderScene> compiled_;
    std::vector<std::string> notes_;
    double setupSeconds_ = 0;
};

}  // namespace

Result<std::unique_ptr<GlintRenderer>> startGlint(const PeerScene& scene) {
    auto renderer = std::make_unique<InProcess>(scene, 0.0);
    const Status ready = renderer->prepare();
    if (!ready) return ready.error();
    return std::unique_ptr<GlintRenderer>(std::move(renderer));
}

}  // namespace glint::bench
