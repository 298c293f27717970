package rasterlab.app.model;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;

/** Tells pictures in which nothing is seen of a scene, which is said where anything is drawn. */
public final class EmptyPicture {
    private static final int OPAQUE = 0xFF000000;

    private EmptyPicture() {}

    /** Whether every pixel has the background's colour. */
    public static boolean is(Raster picture, int backgroundRgb) {
        int background = OPAQUE | backgroundRgb;
        return Arrays.stream(picture.argb()).allMatch(argb -> argb == background);
    }
}
