package rasterlab.engine.pipeline.paint;

import java.util.Arrays;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.OutlineFaces;

/**
 * Phong's shading with fewer formulas: where light mixed from a face's corners is proved to be near
 * enough, it is mixed; the other faces have the formula at each pixel.
 */
public final class MixedLight {
    /** The most that rounding and the pipeline's quick colours may add, in levels. */
    private static final double ROOM = 0.5;

    private final FaceLights lights;
    private final CornerLightBound bound;
    private final double levels;

    /**
     * @param levels the largest difference allowed
     */
    public MixedLight(FaceLights lights, double levels) {
        this(lights, levels, 0);
    }

    /**
     * Makes the light for every eye whose direction from a face differs by at most {@code turn}
     * radians.
     */
    public MixedLight(FaceLights lights, double levels, double turn) {
        this.lights = lights;
        this.levels = levels;
        bound = new CornerLightBound(lights, turn);
    }

    /**
     * Tells which faces need the formula at each pixel. Those at the outline always do: among them
     * the order of drawing tells which is seen, and the others are drawn first.
     *
     * @param drawn the faces that are asked for
     */
    public boolean[] atPixels(boolean[] drawn) {
        boolean[] exact = beyond(drawn);
        boolean[] outline = OutlineFaces.faces(lights.view());
        for (int f = 0; f < exact.length; f++) exact[f] |= drawn[f] && outline[f];
        return exact;
    }

    /** Tells on which of the drawn faces mixed light is not proved to be near enough. */
    public boolean[] beyond(boolean[] drawn) {
        var exact = new boolean[drawn.length];
        for (int f = 0; f < exact.length; f++)
            exact[f] = drawn[f] && bound.levels(f) + ROOM > levels;
        float[] corners = lights.atCorners(mixed(drawn, exact));
        for (int f = 0; f < exact.length; f++)
            if (drawn[f] && !exact[f] && cutBetween(corners, f)) exact[f] = true;
        return exact;
    }

    /**
     * How far from the formula at each pixel less is, in levels, rounding included.
     *
     * @param mixed what light mixed from corners is off at most; infinite where that is not known,
     *     or above the levels allowed
     * @param flat what one colour a face, that of its middle, is off at most
     */
    public record Apart(double mixed, double flat) {
        private static final Apart FAR =
                new Apart(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** The most that all faces are off. */
    public Apart apart() {
        var all = new boolean[lights.mesh().faceCount()];
        Arrays.fill(all, true);
        return apart(all);
    }

    /** The most that the drawn faces are off; the first that is off by too much ends the search. */
    public Apart apart(boolean[] drawn) {
        double mixed = ROOM;
        double flat = ROOM;
        var levels = new double[drawn.length];
        for (int f = 0; f < drawn.length; f++) {
            if (!drawn[f]) continue;
            levels[f] = bound.levels(f) + ROOM;
            if (levels[f] > this.levels) return Apart.FAR;
            mixed = Math.max(mixed, levels[f]);
        }
        float[] corners = lights.atCorners(drawn);
        for (int f = 0; f < drawn.length; f++)
            if (drawn[f] && cutBetween(corners, f)) return Apart.FAR;
        int[] middles = lights.atMiddles(drawn);
        for (int f = 0; f < drawn.length; f++)
            if (drawn[f]) flat = Math.max(flat, levels[f] + apart(corners, f, middles[f]));
        return new Apart(mixed, flat);
    }

    private static boolean[] mixed(boolean[] drawn, boolean[] exact) {
        var mixed = new boolean[drawn.length];
        for (int f = 0; f < mixed.length; f++) mixed[f] = drawn[f] && !exact[f];
        return mixed;
    }

    /** The largest difference of a corner's colour from one colour, in levels. */
    private double apart(float[] corners, int face, int argb) {
        double most = 0;
        for (int k = 0; k < lights.mesh().cornerCount(face); k++)
            for (int c = 0; c < 3; c++) {
                double level = 255 * corners[4 * (lights.mesh().firstCorner(face) + k) + c];
                most = Math.max(most, Math.abs(level - (argb >> 16 - 8 * c & 255)));
            }
        return most;
    }

    /**
     * Whether a channel is cut at 1 at some corner and not at another: a crease within the face.
     */
    private boolean cutBetween(float[] corners, int face) {
        Mesh mesh = lights.mesh();
        for (int c = 0; c < 3; c++) {
            boolean cut = false;
            boolean free = false;
            for (int k = 0; k < mesh.cornerCount(face); k++) {
                boolean atTop = corners[4 * (mesh.firstCorner(face) + k) + c] >= 1;
                cut |= atTop;
                free |= !atTop;
            }
            if (cut && free) return true;
        }
        return false;
    }
}
