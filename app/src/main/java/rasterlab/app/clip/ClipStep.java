package rasterlab.app.clip;

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
    /** Which way something passes a border. */
    public enum Passing {
        /** It comes in. */
        ENTERING,
        /** It goes out. */
        LEAVING,
        /** It comes in at the first place and goes out at the second. */
        BOTH,
        /** It runs along, or no border is looked at. */
        NONE
    }
}
