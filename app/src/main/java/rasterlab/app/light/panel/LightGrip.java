package rasterlab.app.light.panel;

import rasterlab.engine.range.Bounds;

/**
 * Something on the pictures that can be dragged.
 *
 * @param kind what it is
 * @param index of the lamp; 0 for the others
 */
public record LightGrip(LightGripKind kind, int index) {
    public LightGrip {
        Bounds.requireAtLeast("index", index, 0);
    }

    /** The kind of thing that can be dragged. */
    public enum LightGripKind {
        LAMP,
        FROM,
        TO,
        POINT
    }
}
