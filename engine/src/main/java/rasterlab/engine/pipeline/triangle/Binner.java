package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;

/**
 * Triangles: out of sight, clipped, culled, without a pixel's centre, or sorted into bands.
 *
 * <p>One per thread. The order within a band is the mesh's, whichever thread sorts a chunk.
 */
final class Binner {
    private final Clipper clipper = new Clipper();
    private int[] entry = new int[TriangleChunk.SIZE];
    private int[] firstBand = new int[TriangleChunk.SIZE];
    private int[] lastBand = new int[TriangleChunk.SIZE];
    private int kept;

    static int chunks(int triangles) {
        return (triangles + TriangleChunk.SIZE - 1) / TriangleChunk.SIZE;
    }

    void run(Frame frame, int index, TriangleChunk chunk) {
        chunk.begin(frame.bands);
        kept = 0;
        int[] triangles = frame.mesh.triangles();
        short[] code = frame.vertices.code;
        int from = index * TriangleChunk.SIZE;
        int to = Math.min(from + TriangleChunk.SIZE, frame.mesh.triangleCount());
        for (int t = from; t < to; t++) {
            int a = triangles[3 * t];
            int b = triangles[3 * t + 1];
            int c = triangles[3 * t + 2];
            int any = code[a] | code[b] | code[c];
            if (any == 0) keep(frame, frame.vertices, a, b, c, t, chunk);
            else if (!ClipCode.outOfSight(code[a] & code[b] & code[c])) {
                if (ClipCode.mustClip(any)) clip(frame, a, b, c, chunk);
                else keep(frame, frame.vertices, a, b, c, t, chunk);
            }
        }
        sort(chunk, frame.bands);
    }

    private void keep(
            Frame frame, ScreenVertices v, int a, int b, int c, int name, TriangleChunk chunk) {
        int ax = v.x[a];
        int ay = v.y[a];
        int bx = v.x[b];
        int by = v.y[b];
        int cx = v.x[c];
        int cy = v.y[c];
        // y grows down: what turns counter-clockwise on the picture has this sign.
        long twiceArea = (long) (by - ay) * (cx - ax) - (long) (bx - ax) * (cy - ay);
        if (!frame.view.culling().keeps(twiceArea)) return;
        int top = Subpixels.firstPixel(Math.min(ay, Math.min(by, cy)));
        int bottom = Subpixels.endPixel(Math.max(ay, Math.max(by, cy)));
        int left = Subpixels.firstPixel(Math.min(ax, Math.min(bx, cx)));
        int right = Subpixels.endPixel(Math.max(ax, Math.max(bx, cx)));
        if (bottom - top == 1
                && right - left == 1
                && TinyScan.misses(left, top, ax, ay, bx, by, cx, cy, twiceArea > 0)) return;
        top = Math.max(top, 0);
        bottom = Math.min(bottom, frame.out.height());
        if (top >= bottom || Math.max(left, 0) >= Math.min(right, frame.out.width())) return;
        v.need(a, b, c);
        add(name, top / TriangleScan.ROWS, (bottom - 1) / TriangleScan.ROWS, chunk);
    }

    private void add(int name, int first, int last, TriangleChunk chunk) {
        if (kept == entry.length) {
            entry = Arrays.copyOf(entry, 2 * kept);
            firstBand = Arrays.copyOf(firstBand, 2 * kept);
            lastBand = Arrays.copyOf(lastBand, 2 * kept);
        }
        entry[kept] = name;
        firstBand[kept] = first;
        lastBand[kept++] = last;
        for (int band = first; band <= last; band++) chunk.start[band + 1]++;
    }

    /** A fan about the first corner. */
    private void clip(Frame frame, int a, int b, int c, TriangleChunk chunk) {
        ClipPolygon polygon = clipper.clip(frame, a, b, c);
        if (polygon.size < 3) return;
        int first = chunk.clippedVertices;
        for (int k = 0; k < polygon.size; k++) addVertex(frame, polygon, k, c, chunk);
        for (int k = 1; k + 1 < polygon.size; k++) {
            int name = chunk.addClipped(first, first + k, first + k + 1);
            keep(frame, chunk.clipped, first, first + k, first + k + 1, name, chunk);
        }
    }

    /**
     * A vertex of the mesh stays as it is; a new one is divided and rounded like all others.
     *
     * @param third the vertex that colours the triangle where it has one colour only
     */
    private static void addVertex(
            Frame frame, ClipPolygon polygon, int k, int third, TriangleChunk chunk) {
        ScreenVertices to = chunk.clipped;
        int at = chunk.clippedVertices++;
        to.ensure(at + 1, frame.attributeCount);
        int vertex = polygon.vertex[k];
        if (vertex != ClipPolygon.NEW) {
            to.x[at] = frame.vertices.x[vertex];
            to.y[at] = frame.vertices.y[vertex];
            to.depth[at] = frame.vertices.depth[vertex];
            to.nearness[at] = frame.vertices.nearness[vertex];
        } else {
            double[] clip = polygon.values[k];
            double nearness = 1 / clip[3];
            to.x[at] = frame.subpixels.x(clip[0] * nearness);
            to.y[at] = frame.subpixels.y(clip[1] * nearness);
            double depth = 0.5 + 0.5 * (clip[2] * nearness);
            to.depth[at] = (float) Math.max(0, Math.min(1, depth));
            to.nearness[at] = (float) nearness;
        }
        for (int i = 0; i < frame.attributeCount; i++)
            to.attributes[i][at] =
                    frame.flatColors && Frame.isColor(frame.attribute[i])
                            ? frame.vertices.attributes[i][third]
                            : (float) polygon.attribute(k, i);
    }

    /** A counting sort: bands in order, within a band the order of {@link #add}. */
    private void sort(TriangleChunk chunk, int bands) {
        int[] start = chunk.start;
        for (int band = 0; band < bands; band++) start[band + 1] += start[band];
        int total = start[bands];
        if (chunk.entries.length < total)
            chunk.entries = new int[Math.max(total, 3 * chunk.entries.length / 2)];
        for (int k = 0; k < kept; k++)
            for (int band = firstBand[k]; band <= lastBand[k]; band++)
                chunk.entries[start[band]++] = entry[k];
        // Each start has moved to its band's end, which is the next one's start.
        for (int band = bands; band > 0; band--) start[band] = start[band - 1];
        start[0] = 0;
    }
}
