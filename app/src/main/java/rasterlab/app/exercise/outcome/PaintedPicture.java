package rasterlab.app.exercise.outcome;

import java.awt.Graphics2D;
import java.awt.Rectangle;

/** A decoded picture of a case. */
public interface PaintedPicture {
    /**
     * Fills that place as far as the picture's shape lets it.
     *
     * @param part of the case's grid of pixels, in its pixels; a picture that is no grid is shown
     *     whole
     * @param place in view units
     */
    void paint(Graphics2D g, Rectangle part, Rectangle place);
}
