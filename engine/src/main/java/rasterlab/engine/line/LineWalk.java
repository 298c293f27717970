package rasterlab.engine.line;

/**
 * A line on its way from one end to the other, one pixel per step.
 *
 * <p>A new walk stands before its first pixel, since a faulty method may have none. Drain it with
 * {@code while (walk.advance()) out.plot(walk.x(), walk.y());}. Before the first {@link #advance}
 * and after it returned false, the position means nothing.
 */
public interface LineWalk {
    /** Moves to the next pixel; false when there is none, and then again each time. */
    boolean advance();

    /** Column of the current pixel. */
    int x();

    /** Row of the current pixel. */
    int y();

    /**
     * The number by which the method chooses a pixel: {@link SteppedLine#decides} says which one,
     * {@link SteppedLine#decisionFormula} how.
     */
    double decision();
}
