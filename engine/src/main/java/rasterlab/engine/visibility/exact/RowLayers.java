package rasterlab.engine.visibility.exact;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;

/**
 * The faces seen at each pixel of a row, from the nearest to the first opaque one.
 *
 * <p>Faces come in the order of the mesh, so that of equally near ones the earlier stays before the
 * later.
 */
final class RowLayers {
    private final FacePaint paint;
    private final Nearness[] nearness;
    private final int[][] faces;
    private final int[] count;
    private int y;
    private long compared;
    private long painted;

    /**
     * @param nearness of each face: one object for all faces of one plane
     */
    RowLayers(int width, FacePaint paint, Nearness[] nearness) {
        this.paint = paint;
        this.nearness = nearness;
        faces = new int[width][1];
        count = new int[width];
    }

    void begin(int row) {
        y = row;
        Arrays.fill(count, 0);
    }

    /** Takes a face in the columns [from, to). */
    void add(int face, int from, int to) {
        boolean opaque = paint.opaque(face);
        for (int x = from; x < to; x++) add(face, opaque, x);
    }

    private void add(int face, boolean opaque, int x) {
        int[] here = faces[x];
        int at = count[x];
        while (at > 0 && before(face, here[at - 1], x)) at--;
        if (at > 0 && paint.opaque(here[at - 1])) return;
        if (opaque) count[x] = at;
        if (count[x] == here.length) here = faces[x] = Arrays.copyOf(here, 2 * here.length);
        for (int k = count[x]; k > at; k--) here[k] = here[k - 1];
        here[at] = face;
        count[x]++;
    }

    private boolean before(int face, int earlier, int x) {
        compared++;
        return nearness[face] != nearness[earlier]
                && nearness[face].compare(nearness[earlier], x, y) > 0;
    }

    /** Paints the row, the farthest first; pixels that show the same are painted together. */
    void paint(Raster out) {
        int from = 0;
        for (int x = 1; x <= count.length; x++) {
            if (x < count.length && same(from, x)) continue;
            for (int i = count[from] - 1; i >= 0; i--) {
                paint.span(faces[from][i], y, from, x, out);
                painted += x - from;
            }
            from = x;
        }
    }

    private boolean same(int one, int other) {
        return Arrays.equals(faces[one], 0, count[one], faces[other], 0, count[other]);
    }

    /** How often nearnesses were compared. */
    long compared() {
        return compared;
    }

    /** Pixels coloured. */
    long painted() {
        return painted;
    }
}
