package rasterlab.app.polygon.figure;

import rasterlab.engine.range.Bounds;

/**
 * A point of the figure that can be moved.
 *
 * @param index of a corner, counted from 0; 0 for the others, of which there is one
 */
public record Grip(PolygonGripKind kind, int index) {
    public Grip {
        Bounds.requireAtLeast("index", index, 0);
    }

    /** The thing that a grip belongs to. */
    public enum PolygonGripKind {
        CORNER,
        /** The point that is judged step by step. */
        POINT,
        /** The pixel that a fill begins with. */
        SEED,
        /** The pixel where a wall is put up or taken away. */
        PEN
    }

    public static final Grip POINT = new Grip(PolygonGripKind.POINT, 0);
    public static final Grip SEED = new Grip(PolygonGripKind.SEED, 0);
    public static final Grip PEN = new Grip(PolygonGripKind.PEN, 0);

    public static Grip corner(int index) {
        return new Grip(PolygonGripKind.CORNER, index);
    }

    /** Name of the component that moves it. */
    public String componentName() {
        return switch (kind) {
            case CORNER -> "corner." + index;
            case POINT -> "point";
            case SEED -> "seed";
            case PEN -> "pen";
        };
    }
}
