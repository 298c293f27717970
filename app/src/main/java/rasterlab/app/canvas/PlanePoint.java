package rasterlab.app.canvas;

/**
 * A point of a plane that the user may move.
 *
 * @param name of its handle, such as {@code point.0}; told to {@link PlaneEdits}
 * @param x world
 * @param y world
 * @param label painted beside it, "" for none
 * @param accessibleName its name and place for assistive technology, in the window's language
 */
public record PlanePoint(
        String name, double x, double y, HandleShape form, String label, String accessibleName) {
    /** The shape of its handle, so that points of different kinds differ without colour. */
    public enum HandleShape {
        CIRCLE,
        SQUARE,
        DIAMOND
    }
}
