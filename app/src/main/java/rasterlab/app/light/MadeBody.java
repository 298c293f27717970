package rasterlab.app.light;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.engine.scene.Scene;

/** Draws frames, whose body is made once as long as it stays the same. One thread uses it. */
final class MadeBody {
    private final OwnMethods own;
    private final LitPlans plans;
    private Optional<Made> last = Optional.empty();

    /**
     * A body that was drawn.
     *
     * @param by the user's own program that found its normals
     * @param normals those, beside the right ones
     */
    private record Made(
            LitBody body, Optional<OwnProgram> by, Scene scene, Optional<OwnNormals> normals) {}

    MadeBody(OwnMethods own, LitPlans plans) {
        this.own = own;
        this.plans = plans;
    }

    LightFrame.DrawnFrame drawn(LightFrame frame, PictureMaker maker, BooleanSupplier cancelled) {
        LitBody body = frame.choice().body();
        Optional<OwnProgram> by = own.of(OwnNormals.TOPIC).filter(program -> body.asksProgram());
        if (last.filter(made -> made.body().equals(body) && made.by().equals(by)).isEmpty())
            last = Optional.of(made(body, by));
        Made made = last.get();
        return frame.drawn(made.scene(), made.normals(), own, plans, maker, cancelled);
    }

    private Made made(LitBody body, Optional<OwnProgram> by) {
        if (!body.asksProgram()) return new Made(body, by, body.scene(), Optional.empty());
        var normals = OwnNormals.of(body, own);
        return new Made(body, by, normals.scene(), Optional.of(normals));
    }
}
