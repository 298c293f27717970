package rasterlab.engine.transform.view;

import rasterlab.engine.range.Bounds;

/**
 * One of the numbered steps from the world to the eye.
 *
 * @param number from 1, as the text counts
 * @param formula what it computes
 * @param value what that gives for the point
 */
public record ViewStep(int number, String formula, double value) {
    public ViewStep {
        Bounds.requireAtLeast("number", number, 1);
    }
}
