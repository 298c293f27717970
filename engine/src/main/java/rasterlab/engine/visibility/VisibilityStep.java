package rasterlab.engine.visibility;

/** One step of a method that can be watched; its value is what decided, as the method says. */
public sealed interface VisibilityStep {
    double value();

    /** A face, or a piece of one, was drawn. */
    record FaceDrawn(int face, double value) implements VisibilityStep {}

    /** A face was put before another one. */
    record FaceMoved(int face, int before, double value) implements VisibilityStep {}

    /** A face was cut because of another one. */
    record FaceCut(int face, int by, double value) implements VisibilityStep {}

    /** A face was found to be seen in the pixels [from, to) of row y. */
    record SpanSeen(int face, int y, int from, int to, double value) implements VisibilityStep {}

    /**
     * The window of pixels [x, x + width) × [y, y + height) was looked at.
     *
     * @param divided whether it was too complicated and was cut in parts
     */
    record Window(int x, int y, int width, int height, boolean divided, double value)
            implements VisibilityStep {}
}
