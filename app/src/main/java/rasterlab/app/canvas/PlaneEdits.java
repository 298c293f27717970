package rasterlab.app.canvas;

/**
 * Receives what the user does to the points of a plane, in world coordinates, on the event thread.
 */
public interface PlaneEdits {
    /** A drag begins: all moves until {@link #endDrag} are one change. */
    void beginDrag();

    void endDrag();

    /** A point is wanted elsewhere, by the mouse or the keyboard. */
    void move(String point, double x, double y);

    /** A point is wanted where the ground was clicked twice. */
    default void add(double x, double y) {}

    /** A point has got the keyboard. */
    default void select(String point) {}

    /**
     * The ground is dragged by so many view units.
     *
     * @return whether that turned something; otherwise the plane in sight is moved
     */
    default boolean turn(int viewRight, int viewDown) {
        return false;
    }

    /** A point is not wanted any more: the Delete key. */
    default void remove(String point) {}
}
