package rasterlab.engine.visibility.buffer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.BufferedWalk;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.buffer.PixelTouch.DepthTest;
import rasterlab.engine.visibility.buffer.PixelTouch.TouchOutcome;

/**
 * Everything that touched one pixel while a picture was drawn, in the order in which it did.
 *
 * <p>The method draws as it always does; only spans that hold the pixel are painted. A method with
 * steps is asked after each of them, one without is asked about its spans alone. Faces that own the
 * pixel and were never drawn there come last, the nearest first.
 */
public final class PixelHistory {
    private final ViewedMesh view;
    private final int x;
    private final int y;
    private final Raster out;
    private final Recorder recorder;
    private final NearnessPlane plane = new NearnessPlane();
    private final List<PixelTouch> touches = new ArrayList<>();

    private PixelHistory(ViewedMesh view, FacePaint paint, int background, int x, int y) {
        this.view = view;
        this.x = x;
        this.y = y;
        out = new Raster(view.fit().width(), view.fit().height());
        if (!out.contains(x, y))
            throw new IllegalArgumentException(
                    "pixel must be in a picture of %d×%d, got (%d, %d)"
                            .formatted(out.width(), out.height(), x, y));
        out.clear(background);
        recorder = new Recorder(paint, x, y);
    }

    /**
     * @param background the colour 0xAARRGGBB before anything is drawn
     * @param x the pixel's column
     * @param y its row
     * @throws IllegalArgumentException if the pixel is outside, or the method refuses the scene
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static List<PixelTouch> of(
            ViewedMesh view,
            Visibility method,
            FacePaint paint,
            int background,
            int x,
            int y,
            BooleanSupplier cancelled) {
        var history = new PixelHistory(view, paint, background, x, y);
        if (method instanceof SteppedVisibility stepped) history.watch(stepped, cancelled);
        else history.draw(method, cancelled);
        history.addLeftOut(cancelled);
        return List.copyOf(history.touches);
    }

    private void draw(Visibility method, BooleanSupplier cancelled) {
        method.draw(view, recorder, out, cancelled);
        for (Write write : recorder.take())
            add(0, write.face, TouchOutcome.DRAWN, Optional.empty(), write.before, write.after);
    }

    private void watch(SteppedVisibility method, BooleanSupplier cancelled) {
        VisibilityWalk walk = method.walk(view, recorder, out);
        OptionalDouble held = OptionalDouble.empty();
        for (int step = 1; walk.advance(); step++) {
            Cancellation.check(cancelled);
            Optional<DepthTest> test = Optional.empty();
            if (walk instanceof BufferedWalk buffered) {
                test = tested(buffered, held);
                held = buffered.held(x, y);
            }
            record(step, walk.step(), test);
        }
    }

    private Optional<DepthTest> tested(BufferedWalk walk, OptionalDouble held) {
        OptionalDouble offered = walk.offered(x, y);
        return offered.isEmpty()
                ? Optional.empty()
                : Optional.of(new DepthTest(offered.getAsDouble(), held));
    }

    private void record(int step, VisibilityStep done, Optional<DepthTest> test) {
        List<Write> writes = recorder.take();
        for (Write write : writes)
            add(step, write.face, TouchOutcome.DRAWN, test, write.before, write.after);
        int now = out.argb(x, y);
        if (writes.isEmpty() && test.isPresent() && done instanceof VisibilityStep.FaceDrawn drawn)
            add(step, drawn.face(), TouchOutcome.FAILED, test, now, now);
        int last = touches.isEmpty() ? recorder.first : touches.get(touches.size() - 1).after();
        if (now != last && done instanceof VisibilityStep.FaceDrawn drawn)
            add(step, drawn.face(), TouchOutcome.OUTLINED, Optional.empty(), last, now);
    }

    private void add(
            int step,
            int face,
            TouchOutcome verdict,
            Optional<DepthTest> test,
            int before,
            int after) {
        touches.add(new PixelTouch(step, face, depth(face), verdict, test, before, after));
    }

    private double depth(int face) {
        if (!plane.load(view, face)) return Double.POSITIVE_INFINITY;
        double nearness = plane.base + x * plane.perColumn + y * plane.perRow;
        return view.transform().central() ? view.transform().distance() / nearness : -nearness;
    }

    private void addLeftOut(BooleanSupplier cancelled) {
        var known = new boolean[view.mesh().faceCount()];
        touches.forEach(touch -> known[touch.face()] = true);
        int color = touches.isEmpty() ? out.argb(x, y) : touches.get(touches.size() - 1).after();
        var rest = new ArrayList<PixelTouch>();
        var polygon = new ScreenPolygon(view);
        for (int face = 0; face < known.length; face++) {
            Cancellation.check(cancelled);
            if (known[face] || !owns(polygon, face)) continue;
            rest.add(
                    new PixelTouch(
                            0,
                            face,
                            depth(face),
                            TouchOutcome.LEFT_OUT,
                            Optional.empty(),
                            color,
                            color));
        }
        rest.sort(Comparator.comparingDouble(PixelTouch::z));
        touches.addAll(rest);
    }

    private boolean owns(ScreenPolygon polygon, int face) {
        polygon.load(view, face);
        var owned = new boolean[1];
        polygon.fill(
                out.width(),
                out.height(),
                (row, from, to) -> owned[0] |= row == y && from <= x && x < to);
        return owned[0];
    }

    private record Write(int face, int before, int after) {}

    /** Paints only what reaches the pixel; several threads may paint, one of them its row. */
    private final class Recorder implements FacePaint {
        private final FacePaint paint;
        private final int column;
        private final int row;
        private final int first;
        private final List<Write> writes = Collections.synchronizedList(new ArrayList<>());

        Recorder(FacePaint paint, int column, int row) {
            this.paint = paint;
            this.column = column;
            this.row = row;
            first = out.argb(column, row);
        }

        @Override
        public void span(int face, int y, int from, int to, Raster out) {
            if (y != row || column < from || column >= to) return;
            int before = out.argb(column, row);
            paint.span(face, y, from, to, out);
            writes.add(new Write(face, before, out.argb(column, row)));
        }

        @Override
        public boolean opaque(int face) {
            return paint.opaque(face);
        }

        @Override
        public boolean hasOutline() {
            return paint.hasOutline();
        }

        @Override
        public int outline(int face) {
            return paint.outline(face);
        }

        List<Write> take() {
            List<Write> taken = List.copyOf(writes);
            writes.clear();
            return taken;
        }
    }
}
