package rasterlab.engine.pipeline;

import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.painter.ConvexBody;
import rasterlab.engine.visibility.ray.FaceCrossings;
import rasterlab.engine.visibility.ray.SharedPlanes;

/**
 * The cheapest visibility method that is right.
 *
 * <p>Back faces alone are enough for one convex body, closed and opaque. Where two faces lie over
 * each other in one plane, or transparent ones cross, no depth of a whole face is right, so that
 * they are cut by a tree. All else is drawn by depth: by the pipeline, or where a paint must see
 * each face's pixels, by a plain z-buffer. A mesh of many faces is not searched for such pairs.
 */
final class AutoVisibility {
    /** A mesh of more is not searched: whether it is convex costs their square. */
    private static final int FEW_FACES = 300;

    private AutoVisibility() {}

    static Choice of(RenderRequest request) {
        Look look = request.look();
        if (!look.visibility().equals(Renderer.AUTO))
            return new Choice(look.visibility(), "asked for");
        if (look.outline()) return new Choice("painter", "outlines are drawn by painters only");
        Scene scene = request.scene();
        boolean glass = scene.finishes().stream().anyMatch(AutoVisibility::seenThrough);
        if (scene.mesh().faceCount() > FEW_FACES)
            return byDepth(
                    look,
                    glass,
                    "depths are right on all cores, unless faces lie over each other in one plane"
                            + " or transparent ones cross");
        if (!glass && ConvexBody.flaw(scene.mesh()).isEmpty())
            return new Choice("convex", "one convex body: what faces the eye is what is seen");
        ViewedMesh viewed = RequestView.of(request, request.width()).viewed();
        if (SharedPlanes.anyOverlap(viewed))
            return new Choice("bsp", "faces over each other in one plane: the tree keeps an order");
        if (glass && !FaceCrossings.of(viewed, () -> false).isEmpty())
            return new Choice("bsp", "transparent faces cross: the tree cuts them");
        return byDepth(
                look, glass, "no two faces lie over each other in one plane: depths are right");
    }

    private static Choice byDepth(Look look, boolean glass, String reason) {
        boolean plain = look.cue().isEmpty() && look.shading() != ShadingMethod.TONE;
        if (glass && !plain)
            return new Choice("zfloat", "transparent faces, coloured by a paint of their own");
        return new Choice(Renderer.PIPELINE, reason);
    }

    private static boolean seenThrough(Appearance finish) {
        return finish.front().alpha() < 1
                || finish.back().alpha() < 1
                || !finish.texture().map(laid -> laid.opaque()).orElse(true);
    }
}
