package rasterlab.app.clip.scene;

import rasterlab.engine.range.Bounds;

/**
 * A point of the scene that can be moved.
 *
 * @param index counted from 0: a corner of the window or of the polygon, or a segment
 * @param end 0 or 1 for the first or second end of a segment, else 0
 */
public record ClipGrip(ClipGripKind kind, int index, int end) {
    public ClipGrip {
        Bounds.requireAtLeast("index", index, 0);
        Bounds.require("end", end, 0, 1);
    }

    /** The thing that a grip belongs to. */
    public enum ClipGripKind {
        WINDOW,
        CORNER,
        END
    }

    public static ClipGrip window(int corner) {
        return new ClipGrip(ClipGripKind.WINDOW, corner, 0);
    }

    public static ClipGrip corner(int corner) {
        return new ClipGrip(ClipGripKind.CORNER, corner, 0);
    }

    public static ClipGrip end(int segment, int end) {
        return new ClipGrip(ClipGripKind.END, segment, end);
    }

    /**
     * The grip's name as people count: the window's corners by number, a segment's ends as A and B.
     */
    public String label() {
        return kind == ClipGripKind.END
                ? (end == 0 ? "A" : "B") + (index + 1)
                : String.valueOf(index + 1);
    }

    /** Name of the component that moves it. */
    public String componentName() {
        return switch (kind) {
            case WINDOW -> "window." + (index + 1);
            case CORNER -> "corner." + (index + 1);
            case END -> "end." + label();
        };
    }
}
