package rasterlab.engine.pipeline.paint;

/**
 * Far things fade into the background: I = f·I + (1 − f)·B, with f = 1 − strength·(z − nearest) /
 * (farthest − nearest), z being the view depth and nearest and farthest those of the scene.
 *
 * @param strength the share of the background at the farthest point, above 0, up to 1
 */
public record DepthCue(double strength) {
    /** The farthest part is still told from the background. */
    public static final double USUAL = 0.8;

    public DepthCue {
        if (!(strength > 0 && strength <= 1))
            throw new IllegalArgumentException(
                    "depth cue must be above 0, up to 1, got " + strength);
    }
}
