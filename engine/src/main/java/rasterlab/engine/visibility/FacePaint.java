package rasterlab.engine.visibility;

import rasterlab.engine.raster.Raster;

/** The colours of a mesh's faces. Several threads may paint at once, each its own pixels. */
public interface FacePaint {
    /**
     * Colours the pixels [from, to) of row y, in all of which the face is what is painted now.
     *
     * @param from at least 0
     * @param to at most the picture's width, above {@code from}
     * @param out where the face is transparent, what it holds is seen through it
     */
    void span(int face, int y, int from, int to, Raster out);

    /** Whether nothing is seen through a face. */
    default boolean opaque(int face) {
        return true;
    }

    /** Whether faces have outlines. */
    default boolean hasOutline() {
        return false;
    }

    /**
     * The colour 0xAARRGGBB of a face's outline.
     *
     * @throws IllegalStateException where faces have none
     */
    default int outline(int face) {
        throw new IllegalStateException("face " + face + " has no outline");
    }
}
