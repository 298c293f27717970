package rasterlab.engine.visibility.scan;

import java.util.Arrays;

/**
 * The edge table: edges by the row in which they begin, and those that cross the present row.
 *
 * <p>{@link #enter} makes of them, for each face that crosses the row, the crossings on its left
 * and on its right.
 */
final class ActiveEdges {
    private final ScreenFaces faces;
    private final int[] firstInRow;
    private final int[] nextInRow;
    private final int[] placeOf;
    private final int[] upper;
    private final double[] slope;
    private final int[] endRow;
    private int edges;
    private int[] active = new int[64];
    private int activeCount;
    private final int[] crossed;
    private int crossedCount;
    private final int[] seenInRow;
    private final double[] left;
    private final double[] right;

    ActiveEdges(ScreenFaces faces, int height) {
        this.faces = faces;
        int corners = faces.firstCorner(faces.count());
        firstInRow = new int[height];
        Arrays.fill(firstInRow, -1);
        nextInRow = new int[corners];
        placeOf = new int[corners];
        upper = new int[corners];
        slope = new double[corners];
        endRow = new int[corners];
        crossed = new int[faces.count()];
        seenInRow = new int[faces.count()];
        Arrays.fill(seenInRow, -1);
        left = new double[faces.count()];
        right = new double[faces.count()];
        for (int place = 0; place < faces.count(); place++) {
            int end = faces.firstCorner(place + 1);
            for (int k = faces.firstCorner(place), p = end - 1; k < end; p = k++)
                add(place, p, k, height);
        }
    }

    private void add(int place, int p, int k, int height) {
        int high = faces.y(p) < faces.y(k) ? p : k;
        int low = high == p ? k : p;
        int begin = (int) Math.max(0, Math.ceil(faces.y(high)));
        int end = (int) Math.min(height, Math.ceil(faces.y(low)));
        if (begin >= end) return;
        placeOf[edges] = place;
        upper[edges] = high;
        slope[edges] = (faces.x(low) - faces.x(high)) / (faces.y(low) - faces.y(high));
        endRow[edges] = end;
        nextInRow[edges] = firstInRow[begin];
        firstInRow[begin] = edges++;
    }

    /** Goes to a row; rows come one after the other from 0. */
    void enter(int row) {
        for (int edge = firstInRow[row]; edge >= 0; edge = nextInRow[edge]) {
            if (activeCount == active.length) active = Arrays.copyOf(active, 2 * activeCount);
            active[activeCount++] = edge;
        }
        crossedCount = 0;
        int kept = 0;
        for (int i = 0; i < activeCount; i++) {
            int edge = active[i];
            if (row >= endRow[edge]) continue;
            active[kept++] = edge;
            cross(edge, row);
        }
        activeCount = kept;
    }

    private void cross(int edge, int row) {
        int place = placeOf[edge];
        int corner = upper[edge];
        double crossing = faces.x(corner) + (row - faces.y(corner)) * slope[edge];
        if (seenInRow[place] != row) {
            seenInRow[place] = row;
            crossed[crossedCount++] = place;
            left[place] = crossing;
            right[place] = crossing;
        }
        left[place] = Math.min(left[place], crossing);
        right[place] = Math.max(right[place], crossing);
    }

    /** Number of faces that cross the row. */
    int crossedCount() {
        return crossedCount;
    }

    int crossed(int i) {
        return crossed[i];
    }

    /** The first column that a face owns in the row. */
    int from(int place) {
        return (int) Math.max(0, Math.ceil(left[place]));
    }

    /** The column after the last that it owns. */
    int to(int place, int width) {
        return (int) Math.min(width, Math.ceil(right[place]));
    }
}
