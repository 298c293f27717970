package rasterlab.app.row;

import rasterlab.engine.range.Bounds;

/**
 * The user's choice, which undo brings back.
 *
 * @param topic of rows
 * @param hazard one of its hazards
 * @param method one of its methods
 * @param pixel whose numbers are shown, from 0
 */
public record RowChoice(String topic, String hazard, String method, int pixel) {
    public RowChoice {
        Bounds.requireAtLeast("pixel", pixel, 0);
    }

    RowChoice withMethod(String other) {
        return new RowChoice(topic, hazard, other, pixel);
    }

    RowChoice at(int other) {
        return new RowChoice(topic, hazard, method, other);
    }
}
