package rasterlab.app.canvas.file;

/**
 * A lab, or a part of one, that opens as it was left.
 *
 * @param <C> an immutable choice: a record or enum that Jackson writes and reads by itself
 */
public interface Kept<C> {
    Class<C> keptType();

    /** The user's choice. */
    C kept();

    /**
     * Shows what was kept in an earlier run; there is nothing to undo afterwards.
     *
     * @throws IllegalArgumentException if it cannot be shown, such as with a method that there is
     *     no more; what was shown stays
     */
    void restore(C choice);
}
