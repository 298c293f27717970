package rasterlab.engine.visibility;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;

/**
 * One opaque colour 0xAARRGGBB per face, and one for its outline.
 *
 * <p>The arrays are not copied, since a picture reads them once for each face: whoever makes a
 * paint does not write into them afterwards.
 *
 * @param fill by face
 * @param outlines by face; an empty array where no outline is drawn
 */
public record FlatPaint(int[] fill, int[] outlines) implements FacePaint {
    public FlatPaint {
        if (outlines.length != 0 && outlines.length != fill.length)
            throw new IllegalArgumentException(
                    "outline needs a colour for none or each of %d faces, got %d"
                            .formatted(fill.length, outlines.length));
    }

    @Override
    public void span(int face, int y, int from, int to, Raster out) {
        int row = y * out.width();
        Arrays.fill(out.argb(), row + from, row + to, fill[face]);
    }

    @Override
    public boolean hasOutline() {
        return outlines.length != 0;
    }

    @Override
    public int outline(int face) {
        return outlines[face];
    }
}
