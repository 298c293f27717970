package rasterlab.app.clip.outcome;

import java.util.Arrays;
import rasterlab.engine.range.Bounds;

/**
 * One step of a method.
 *
 * @param item index of the segment it belongs to; 0 for a polygon
 * @param at what it looked at, in the method's own word
 * @param border index of the tested side ({@link Borders}), −1 for none
 * @param decision the number it decided by; not a number where there is none
 * @param passing which way the segment passes the tested border
 * @param places where it does so, point after point; not finite where it does not
 * @param left coordinates of what is not yet cut off: two ends, or the corners of a polygon
 */
public record ClipStep(
        int item,
        String at,
        int border,
        double decision,
        Passing passing,
        double[] places,
        double[] left) {
    /** A method without steps, such as the user's program, sent this for an item. */
    private static final String WRITTEN = "written";

    public ClipStep {
        Bounds.requireAtLeast("item", item, 0);
        Bounds.requireAtLeast("border", border, -1);
    }

    /**
     * The step of a method that tells nothing but what it sent.
     *
     * @param left the two ends that it sent; none where it sent none
     */
    static ClipStep written(int item, double[] left) {
        return new ClipStep(item, WRITTEN, -1, Double.NaN, Passing.NONE, new double[0], left);
    }

    /** Writes a piece of a polygon, whose outline is closed. */
    public static ClipStep writtenPiece(double[] piece) {
        double[] around = Arrays.copyOf(piece, piece.length + 2);
        System.arraycopy(piece, 0, around, piece.length, 2);
        return new ClipStep(0, WRITTEN, -1, piece.length / 2, Passing.NONE, new double[0], around);
    }

    /** Which way something passes a border. */
    public enum Passing {
        /** The segment comes in. */
        ENTERING,
        /** The segment goes out. */
        LEAVING,
        /** The segment comes in at the first place and goes out at the second. */
        BOTH,
        /** The segment runs along, or no border is looked at. */
        NONE
    }
}
