package rasterlab.engine.visibility.buffer;

import java.util.Arrays;
import java.util.OptionalDouble;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.BufferedWalk;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.SpanSink;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * Keeps the nearest depth so far of each pixel; a face colours those pixels where it is nearer. Of
 * equal depths the earlier face stays.
 *
 * <p>The depth is nearness, ρ/z in perspective and −z in parallel projection: it grows towards the
 * eye and, unlike z, is linear on the screen. {@link DepthCodes} stores it as an int, the smaller
 * one being the nearer; how many bits that takes is no matter here.
 *
 * <p>{@link OpaqueFirst} orders the faces: transparent ones come last and are blended where nothing
 * opaque is nearer, leaving the depths as they are. {@link ScreenPolygon} clips a face, projects it
 * and finds the pixels inside, row by row. {@link NearnessPlane} holds the linear function of a
 * face. {@link SpareDepths} lends the last frame's memory.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, PhD
 * thesis, University of Utah, 1974.
 */
final class ZBuffer implements SteppedVisibility {
    private final DepthCodes.DepthCodesFactory format;
    private final SpareDepths spare = new SpareDepths();

    ZBuffer(DepthCodes.DepthCodesFactory format) {
        this.format = format;
    }

    /** This method with buffers of its own. */
    ZBuffer alone() {
        return new ZBuffer(format);
    }

    @Override
    public String decision() {
        return "pixels in which the face is nearer than what they held";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out);
    }

    private final class Walk implements BufferedWalk {
        private final ViewedMesh view;
        private final FacePaint paint;
        private final Raster out;
        private final int width;
        private final int height;
        private final Tally tally = new Tally();
        private final OpaqueFirst order;
        private final DepthCodes depths;
        private final ScreenPolygon polygon;
        private final NearnessPlane plane = new NearnessPlane();
        private final SpanSink eachRow = this::drawRow;

        /** The depth code of the nearest face so far, for each pixel of the picture. */
        private final int[] nearest;

        /** The depth codes of one face along one row, the first for its first pixel inside. */
        private final int[] codes;

        private int drawn;
        private int face;
        private long nearer;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            this.paint = paint;
            this.out = out;
            width = out.width();
            height = out.height();
            order = OpaqueFirst.of(view, paint, tally);
            depths = format.over(NearnessRange.of(view));
            polygon = new ScreenPolygon(view);
            codes = new int[width];
            nearest = spare.take(width * height);
            Arrays.fill(nearest, DepthCodes.EMPTY); // farther than every face
        }

        /** Draws the next face. */
        @Override
        public boolean advance() {
            if (drawn == order.faces().length) {
                spare.giveBack(nearest);
                return false;
            }
            face = order.faces()[drawn++];
            long before = tally.pixelsWritten;
            boolean edgeOn = !plane.load(view, face);
            if (!edgeOn) {
                polygon.load(view, face);
                polygon.fill(width, height, eachRow);
            }
            nearer = tally.pixelsWritten - before;
            return true;
        }

        /** Draws the face's pixels inside in row y, from {@code from} to {@code to} − 1. */
        private void drawRow(int y, int from, int to) {
            // nearness(x, y) = base + x·perColumn + y·perRow, as codes
            depths.row(plane.base + y * plane.perRow, plane.perColumn, from, to, codes);
            tally.depthTests += to - from;
            boolean opaque = drawn <= order.opaque();
            int row = y * width;
            int visibleFrom = from;
            for (int x = from; x < to; x++) {
                int code = codes[x - from];
                if (code < nearest[row + x]) {
                    if (opaque) nearest[row + x] = code;
                } else {
                    color(y, visibleFrom, x);
                    visibleFrom = x + 1;
                }
            }
            color(y, visibleFrom, to);
        }

        /** Colours a run of visible pixels at once, so that the paint prepares only once for it. */
        private void color(int y, int from, int to) {
            if (from == to) return;
            tally.pixelsWritten += to - from;
            paint.span(face, y, from, to, out);
        }

        @Override
        public VisibilityStep step() {
            return new VisibilityStep.FaceDrawn(face, nearer);
        }

        @Override
        public OptionalDouble held(int x, int y) {
            int code = nearest[y * width + x];
            return code == DepthCodes.EMPTY
                    ? OptionalDouble.empty()
                    : OptionalDouble.of(depths.depth(code));
        }

        @Override
        public OptionalDouble offered(int x, int y) {
            return OfferedDepth.at(x, y, width, height, view, face, depths);
        }

        @Override
        public boolean largerIsNearer() {
            return depths.largerIsNearer();
        }

        @Override
        public VisibilityWork work() {
            return tally.work();
        }
    }
}
