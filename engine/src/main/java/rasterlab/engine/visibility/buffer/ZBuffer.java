package rasterlab.engine.visibility.buffer;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
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
import rasterlab.engine.visibility.painter.Painter;

/**
 * A depth for each pixel; a face colours those pixels where it is nearer than what they hold. Of
 * equal codes the earlier face stays.
 *
 * <p>Transparent faces come last, the farthest mean z first, and are blended where nothing opaque
 * is nearer; they leave the depths as they are. Where they pierce each other a mean cannot order
 * them.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
 */
final class ZBuffer implements SteppedVisibility {
    /** A larger buffer is not kept between frames, in pixels: a screen of 3840×2160 fits. */
    private static final int LARGEST_KEPT = 1 << 23;

    private final DepthCodes.Format format;

    /** The buffer of the last frame, for the next one of the same size. */
    private final AtomicReference<int[]> spare = new AtomicReference<>(new int[0]);

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

    private int[] takeBuffer(int pixels) {
        int[] last = spare.getAndSet(new int[0]);
        int[] buffer = last.length == pixels ? last : new int[pixels];
        Arrays.fill(buffer, DepthCodes.EMPTY);
        return buffer;
    }

    private final class Walk implements BufferedWalk {
        private final ViewedMesh view;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final int width;
        private final int height;
        private final int[] order;
        private final int opaque;
        private final int[] nearest;
        private final int[] codes;
        private final DepthCodes depths;
        private final ScreenPolygon polygon;
        private final NearnessPlane plane = new NearnessPlane();
        private final SpanSink test = this::test;
        private int drawn;
        private int face;
        private long nearer;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            width = out.width();
            height = out.height();
            brush = new FaceBrush(paint, out, tally);
            int faces = view.mesh().faceCount();
            int[] hiding = IntStream.range(0, faces).filter(paint::opaque).toArray();
            opaque = hiding.length;
            order = opaque == faces ? hiding : transparentLast(hiding, paint);
            depths = format.over(NearnessRange.of(view));
            codes = new int[width];
            polygon = new ScreenPolygon(view);
            nearest = takeBuffer(width * height);
        }

        private int[] transparentLast(int[] hiding, FacePaint paint) {
            int[] seenThrough =
                    IntStream.range(0, view.mesh().faceCount())
                            .filter(each -> !paint.opaque(each))
                            .toArray();
            int[] sorted = Painter.farthestFirst(Painter.meanZ(view), seenThrough, tally);
            return IntStream.concat(IntStream.of(hiding), IntStream.of(sorted)).toArray();
        }

        @Override
        public boolean advance() {
            if (drawn == order.length) {
                if (nearest.length <= LARGEST_KEPT) spare.set(nearest);
                return false;
            }
            face = order[drawn++];
            nearer = tally.pixelsWritten;
            if (plane.load(view, face)) {
                polygon.load(view, face);
                polygon.fill(width, height, test);
            }
            nearer = tally.pixelsWritten - nearer;
            return true;
        }

        private void test(int y, int from, int to) {
            tally.depthTests += to - from;
            depths.row(plane.base + y * plane.perRow, plane.perColumn, from, to, codes);
            if (drawn <= opaque) keep(y, from, to);
            else blend(y, from, to);
        }

        private void keep(int y, int from, int to) {
            int row = y * width;
            int seenFrom = -1;
            for (int x = from; x < to; x++) {
                int here = codes[x - from];
                boolean wins = here < nearest[row + x];
                if (wins) nearest[row + x] = here;
                if (wins && seenFrom < 0) seenFrom = x;
                if (wins || seenFrom < 0) continue;
                brush.span(face, y, seenFrom, x);
                seenFrom = -1;
            }
            if (seenFrom >= 0) brush.span(face, y, seenFrom, to);
        }

        private void blend(int y, int from, int to) {
            int row = y * width;
            int seenFrom = -1;
            for (int x = from; x < to; x++) {
                boolean seen = codes[x - from] < nearest[row + x];
                if (seen && seenFrom < 0) seenFrom = x;
                if (seen || seenFrom < 0) continue;
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

        /** The depth along the face's whole span, since a sum along it drifts. */
        @Override
        public OptionalDouble offered(int x, int y) {
            var found = new double[] {Double.NaN};
            if (!plane.load(view, face)) return OptionalDouble.empty();
            polygon.load(view, face);
            polygon.fill(
                    width,
                    height,
                    (row, from, to) -> {
                        if (row != y || x < from || x >= to) return;
                        depths.row(
                                plane.base + row * plane.perRow, plane.perColumn, from, to, codes);
                        found[0] = depths.depth(codes[x - from]);
                    });
            return Double.isNaN(found[0]) ? OptionalDouble.empty() : OptionalDouble.of(found[0]);
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
