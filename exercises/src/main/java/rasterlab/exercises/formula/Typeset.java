package rasterlab.exercises.formula;

import java.awt.Shape;
import rasterlab.exercises.score.Message;

/** A formula set in type, or why it cannot be. */
public sealed interface Typeset {
    /**
     * @param outline what is to be filled; nobody may change it
     * @param width from the left end, in em
     * @param height above the baseline, in em
     * @param depth below the baseline, in em
     */
    record FormulaOutline(Shape outline, double width, double height, double depth)
            implements Typeset {
        /** How high a small x is, in em. */
        public static final double X_HEIGHT = 0.431;

        /** How high a capital is, in em. */
        public static final double CAPITAL_HEIGHT = 0.683;
    }

    /** The fault that was found. */
    record Mistaken(Message message) implements Typeset {}
}
