package rasterlab.engine.pipeline.fast;

import java.util.Arrays;

/**
 * Triangles: out of sight, clipped, culled, or sorted into bands.
 *
 * <p>One per thread. The order within a band is the mesh's, whichever thread sorts a chunk.
 */
final class Binner {
    private final Clipper clipper = new Clipper();
    private int[] corners = new int[3 * TriangleChunk.SIZE];
    private int[] firstBand = new int[TriangleChunk.SIZE];
    private int[] lastBand = new int[TriangleChunk.SIZE];
    private int kept;

    static int chunks(int triangles) {
        return (triangles + TriangleChunk.SIZE - 1) / TriangleChunk.SIZE;
    }

    void run(FrameState frame, int index, TriangleChunk chunk) {
        chunk.begin(frame.bands, frame.attributeCount);
        kept = 0;
        int from = index * TriangleChunk.SIZE;
        int to = Math.min(from + TriangleChunk.SIZE, frame.mesh.triangleCount());
        if (frame.anyBeyond) sortOutBeyond(frame, from, to, chunk);
        else keepAll(frame, from, to, chunk);
        sort(chunk, frame.bands);
    }

    private void keepAll(FrameState frame, int from, int to, TriangleChunk chunk) {
        int[] triangles = frame.mesh.triangles();
        for (int t = 3 * from; t < 3 * to; t += 3)
            keep(frame, frame.vertices, triangles[t], triangles[t + 1], triangles[t + 2], chunk);
    }

    /** Sorts where some vertices lie beyond a plane. */
    private void sortOutBeyond(FrameState frame, int from, int to, TriangleChunk chunk) {
        int[] triangles = frame.mesh.triangles();
        short[] code = frame.vertices.code;
        for (int t = 3 * from; t < 3 * to; t += 3) {
            int a = triangles[t];
            int b = triangles[t + 1];
            int c = triangles[t + 2];
            if (ClipCode.outOfSight(code[a] & code[b] & code[c])) continue;
            if (ClipCode.mustClip(code[a] | code[b] | code[c])) clip(frame, a, b, c, chunk);
            else keep(frame, frame.vertices, a, b, c, chunk);
        }
    }

    private void keep(
            FrameState frame, ScreenVertices v, int a, int b, int c, TriangleChunk chunk) {
        int ax = v.x(a);
        int ay = v.y(a);
        int bx = v.x(b);
        int by = v.y(b);
        int cx = v.x(c);
        int cy = v.y(c);
        // y grows down, so a triangle that is counter-clockwise on the picture has this sign.
        long twiceArea = (long) (by - ay) * (cx - ax) - (long) (bx - ax) * (cy - ay);
        if (!frame.view.culling().keeps(twiceArea)) return;
        int top = Subpixels.firstPixel(Math.min(ay, Math.min(by, cy)));
        int bottom = Subpixels.endPixel(Math.max(ay, Math.max(by, cy)));
        int left = Subpixels.firstPixel(Math.min(ax, Math.min(bx, cx)));
        int right = Subpixels.endPixel(Math.max(ax, Math.max(bx, cx)));
        top = Math.max(top, 0);
        bottom = Math.min(bottom, frame.picture.height());
        if (top >= bottom || Math.max(left, 0) >= Math.min(right, frame.picture.width())) return;
        v.need(a, b, c);
        // A vertex that clipping made is kept as its complement ~v, which is v ^ −1.
        int complement = v == chunk.clipped ? -1 : 0;
        add(a ^ complement, b ^ complement, c ^ complement, top, bottom - 1, chunk);
    }

    /**
     * @param firstRow of pixels, in the picture
     * @param lastRow the last one that the triangle touches
     */
    private void add(int a, int b, int c, int firstRow, int lastRow, TriangleChunk chunk) {
        if (kept == firstBand.length) {
            corners = Arrays.copyOf(corners, 6 * kept);
            firstBand = Arrays.copyOf(firstBand, 2 * kept);
            lastBand = Arrays.copyOf(lastBand, 2 * kept);
        }
        corners[3 * kept] = a;
        corners[3 * kept + 1] = b;
        corners[3 * kept + 2] = c;
        int first = firstRow >> TriangleScan.ROW_BITS;
        int last = lastRow >> TriangleScan.ROW_BITS;
        firstBand[kept] = first;
        lastBand[kept++] = last;
        for (int band = first; band <= last; band++) chunk.start[band + 1]++;
    }

    /** Adds a fan about the first corner. */
    private void clip(FrameState frame, int a, int b, int c, TriangleChunk chunk) {
        ClipPolygon polygon = clipper.clip(frame, a, b, c);
        if (polygon.size < 3) return;
        int first = chunk.clippedVertices;
        for (int k = 0; k < polygon.size; k++) addVertex(frame, polygon, k, c, chunk);
        for (int k = 1; k + 1 < polygon.size; k++)
            keep(frame, chunk.clipped, first, first + k, first + k + 1, chunk);
    }

    /**
     * A vertex of the mesh stays as it is; a new one is divided and rounded like all others.
     *
     * @param third the vertex that colours the triangle where it has one colour only
     */
    private static void addVertex(
            FrameState frame, ClipPolygon polygon, int k, int third, TriangleChunk chunk) {
        ScreenVertices to = chunk.clipped;
        int at = chunk.clippedVertices++;
        to.ensure(at + 1);
        int vertex = polygon.vertex[k];
        if (vertex != ClipPolygon.NEW) {
            ScreenVertices v = frame.vertices;
            to.put(at, v.x(vertex), v.y(vertex), v.depth(vertex), v.nearness(vertex));
        } else {
            double[] clip = polygon.values[k];
            double nearness = 1 / clip[3];
            double depth = 0.5 + 0.5 * (clip[2] * nearness);
            to.put(
                    at,
                    frame.subpixels.x(clip[0] * nearness),
                    frame.subpixels.y(clip[1] * nearness),
                    (float) Math.max(0, Math.min(1, depth)),
                    (float) nearness);
        }
        for (int i = 0; i < frame.attributeCount; i++)
            to.putAttribute(
                    i,
                    at,
                    frame.flatColors && FrameState.isColor(frame.attribute[i])
                            ? frame.vertices.attribute(i, third)
                            : (float) polygon.attribute(k, i));
    }

    /** Does a counting sort: bands in order, within a band the order of {@link #add}. */
    private void sort(TriangleChunk chunk, int bands) {
        int[] start = chunk.start;
        for (int band = 0; band < bands; band++) start[band + 1] += start[band];
        int total = 3 * start[bands];
        if (chunk.corners.length < total)
            chunk.corners = new int[Math.max(total, 3 * chunk.corners.length / 2)];
        int[] sorted = chunk.corners;
        for (int k = 0; k < kept; k++)
            for (int band = firstBand[k]; band <= lastBand[k]; band++) {
                int at = 3 * start[band]++;
                sorted[at] = corners[3 * k];
                sorted[at + 1] = corners[3 * k + 1];
                sorted[at + 2] = corners[3 * k + 2];
            }
        // Each start has moved to its band's end, which is the next one's start.
        for (int band = bands; band > 0; band--) start[band] = start[band - 1];
        start[0] = 0;
    }
}
