package rasterlab.engine.visibility.buffer;

import java.util.OptionalDouble;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.BufferedWalk;
import rasterlab.engine.visibility.FaceBrush;
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
 * A depth for each pixel; a face colours those pixels where it is nearer than what they hold. Of
 * equal codes the earlier face stays.
 *
 * <p>Transparent faces come last ({@link OpaqueFirst}) and are blended where nothing opaque is
 * nearer; they leave the depths as they are.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
 */
final class ZBuffer implements SteppedVisibility {
    private final DepthCodes.Format format;
    private final SpareDepths spare = new SpareDepths();

    ZBuffer(DepthCodes.Format format) {
        this.format = format;
    }

    /** The same method with buffers of its own. */
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
        private final int width;
        private final int height;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final OpaqueFirst order;
        private final DepthCodes depths;
        private final ScreenPolygon polygon;
        private final NearnessPlane plane = new NearnessPlane();
        private final SpanSink rows = this::drawRow;

        /** The code of the nearest depth so far, for each pixel of the picture. */
        private final int[] nearest;

        /** The codes of the face along a row. */
        private final int[] codes;

        private int drawn;
        private int face;
        private long nearer;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            width = out.width();
            height = out.height();
            brush = new FaceBrush(paint, out, tally);
            order = OpaqueFirst.of(view, paint, tally);
            depths = format.over(NearnessRange.of(view));
            polygon = new ScreenPolygon(view);
            nearest = spare.takeEmpty(width * height);
            codes = new int[width];
        }

        @Override
        public boolean advance() {
            if (drawn == order.faces().length) {
                spare.giveBack(nearest);
                return false;
            }
            face = order.faces()[drawn++];
            long before = tally.pixelsWritten;
            if (plane.load(view, face)) {
                polygon.load(view, face);
                polygon.fill(width, height, rows);
            }
            nearer = tally.pixelsWritten - before;
            return true;
        }

        /**
         * Colours the pixels from {@code from} to {@code to} − 1 of row y where the face is nearer.
         */
        private void drawRow(int y, int from, int to) {
            tally.depthTests += to - from;
            depths.row(plane.base + y * plane.perRow, plane.perColumn, from, to, codes);
            boolean hides = drawn <= order.opaque();
            int row = y * width;
            int seenFrom = -1;
            for (int x = from; x < to; x++) {
                int code = codes[x - from];
                boolean isNearer = code < nearest[row + x];
                if (isNearer && hides) nearest[row + x] = code;
                if (isNearer && seenFrom < 0) seenFrom = x;
                if (isNearer || seenFrom < 0) continue;
                brush.span(face, y, seenFrom, x);
                seenFrom = -1;
            }
            if (seenFrom >= 0) brush.span(face, y, seenFrom, to);
        }

        @Override
        public VisibilityStep step() {
            return new VisibilityStep.Drawn(face, nearer);
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
