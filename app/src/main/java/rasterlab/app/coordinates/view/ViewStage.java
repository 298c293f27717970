package rasterlab.app.coordinates.view;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.transform.matrix.MatrixCall;

/**
 * One station of the points.
 *
 * @param calls the matrices that lead to it from the station before, left to right
 */
record ViewStage(CoordinateSpace space, List<MatrixCall> calls) {
    /** Whose coordinates they are. */
    enum CoordinateSpace {
        OBJECT,
        WORLD,
        EYE,
        PICTURE,
        SCREEN;

        String code() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** Whether it has depth and is drawn as a view of space. */
        boolean deep() {
            return ordinal() <= EYE.ordinal();
        }
    }

    ViewStage {
        calls = List.copyOf(calls);
    }
}
