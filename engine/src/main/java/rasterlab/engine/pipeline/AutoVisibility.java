package rasterlab.engine.pipeline;

import rasterlab.engine.scene.Finish;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.visibility.ConvexBody;

/**
 * The cheapest visibility method that is right.
 *
 * <p>Back faces alone are enough for one convex body, closed and opaque. Painters need a proof that
 * their order is right, which costs more than depths do, so all else is drawn by depth: by the
 * pipeline, or where a paint must see each face's pixels, by a plain z-buffer.
 */
final class AutoVisibility {
    /** A body of more faces is not asked whether it is convex, which costs their square. */
    private static final int FEW_FACES = 300;

    private AutoVisibility() {}

    static Choice of(RenderRequest request) {
        Look look = request.look();
        if (!look.visibility().equals(Renderer.AUTO))
            return new Choice(look.visibility(), "asked for");
        if (look.outline()) return new Choice("painter", "outlines are drawn by painters only");
        Scene scene = request.scene();
        int faces = scene.mesh().faceCount();
        if (faces <= FEW_FACES && ConvexBody.flaw(scene.mesh()).isEmpty())
            return new Choice("convex", "one convex body: what faces the eye is what is seen");
        boolean glass = scene.finishes().stream().anyMatch(AutoVisibility::seenThrough);
        boolean plain = look.cue().isEmpty() && look.shading() != ShadingMethod.TONE;
        if (glass && !plain)
            return new Choice("zfloat", "transparent faces, coloured by a paint of their own");
        return new Choice(Renderer.PIPELINE, "depths are right for any scene, on all cores");
    }

    private static boolean seenThrough(Finish finish) {
        return finish.front().alpha() < 1
                || finish.back().alpha() < 1
                || !finish.texture().map(laid -> laid.opaque()).orElse(true);
    }
}
