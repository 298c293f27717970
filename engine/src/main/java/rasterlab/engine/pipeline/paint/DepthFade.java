package rasterlab.engine.pipeline.paint;

import rasterlab.engine.visibility.ViewedMesh;

/** A {@link DepthCue} over one view. */
public final class DepthFade {
    private final int background;
    private final double nearest;
    private final double perUnit;

    /**
     * @param backgroundRgb what everything fades into
     */
    public DepthFade(DepthCue cue, ViewedMesh view, int backgroundRgb) {
        background = backgroundRgb;
        double near = Double.POSITIVE_INFINITY;
        double far = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < view.mesh().vertexCount(); v++) {
            near = Math.min(near, view.eyeZ(v));
            far = Math.max(far, view.eyeZ(v));
        }
        nearest = Math.max(near, view.near());
        double depth = Math.min(far, view.far()) - nearest;
        perUnit = depth > 0 ? cue.strength() / depth : 0;
    }

    /** A colour 0xAARRGGBB as it is seen from view depth z; its alpha stays. */
    public int over(int argb, double z) {
        double share = Math.max(0, Math.min(1, perUnit * (z - nearest)));
        return argb & 0xFF000000
                | channel(argb, 16, share) << 16
                | channel(argb, 8, share) << 8
                | channel(argb, 0, share);
    }

    private int channel(int argb, int shift, double share) {
        int own = argb >> shift & 255;
        int behind = background >> shift & 255;
        return (int) (own + share * (behind - own) + 0.5);
    }
}
