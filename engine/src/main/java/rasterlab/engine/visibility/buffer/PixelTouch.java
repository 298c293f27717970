package rasterlab.engine.visibility.buffer;

import java.util.Optional;
import java.util.OptionalDouble;
import rasterlab.engine.range.Bounds;

/**
 * The effect of a face on one pixel.
 *
 * @param step of the method, from 1; 0 where it has no steps or never came to the face there
 * @param face number in the mesh
 * @param z view depth of the face's plane at the pixel; infinite for a face seen edge-on
 * @param verdict what became of the face there
 * @param test the depths that were compared, where the method keeps a buffer of them
 * @param before the pixel's colour 0xAARRGGBB before
 * @param after and after
 */
public record PixelTouch(
        int step,
        int face,
        double z,
        TouchOutcome verdict,
        Optional<DepthTest> test,
        int before,
        int after) {
    public PixelTouch {
        Bounds.requireAtLeast("step", step, 0);
    }

    /** The fate of a face at a pixel. */
    public enum TouchOutcome {
        /** The pixel got its colour, or was mixed with it. */
        DRAWN,
        /** The pixel got the colour of its outline. */
        OUTLINED,
        /** The buffer held something nearer. */
        FAILED,
        /** The method never drew it there: culled, or found hidden without asking the pixel. */
        LEFT_OUT
    }

    /**
     * @param offered the face's own depth, as the method stores it
     * @param held what the pixel held; empty for the first face there
     */
    public record DepthTest(double offered, OptionalDouble held) {}
}
