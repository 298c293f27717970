package rasterlab.engine.visibility.painter;

import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.SpanSink;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.OrderStep;
import rasterlab.engine.visibility.order.OrderWalk;
import rasterlab.engine.visibility.order.SteppedOrder;

/**
 * Faces and pieces of them in an order in which none hides one after it, each painted over the ones
 * before: a method of topic {@code depth-order}, in {@link SightSpace}.
 *
 * <p>A piece is filled as its whole face, up to its cuts, and not by its own corners: those lie on
 * the edges of the face only nearly, and pixels on such an edge would be lost.
 *
 * <p>Sources: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem,
 * ACM Annual Conference, 1972, pp. 443–450; H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface
 * generation by a priori tree structures, SIGGRAPH 1980, pp. 124–133.
 */
final class OrderedPieces implements SteppedVisibility {
    private final SteppedOrder method;

    /**
     * @param name of a method of the topic that has steps
     */
    OrderedPieces(String name) {
        Topic<DepthOrder, ?, ?> topic = new DepthOrderTopic();
        method = (SteppedOrder) topic.method(name).implementation();
    }

    @Override
    public String decision() {
        return method.decision() + ", of the space in which the faces are ordered";
    }

    /**
     * @throws IllegalArgumentException if the order would take too many pieces or comparisons
     */
    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out, () -> {});
    }

    @Override
    public VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        Runnable pulse = () -> Cancellation.check(cancelled);
        pulse.run();
        VisibilityWalk walk = new Walk(view, paint, out, pulse);
        boolean more;
        do {
            pulse.run();
            more = walk.advance();
        } while (more);
        return walk.work();
    }

    private final class Walk implements PiecesWalk {
        private final ViewedMesh view;
        private final SightSpace space;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final OrderWalk order;
        private final ScreenPolygon whole;
        private final Raster out;
        private final SpanSink cut = this::fillCut;
        private CutLine[] cuts = {};
        private double[] sightCorners = {};
        private int face;

        Walk(ViewedMesh view, FacePaint paint, Raster out, Runnable pulse) {
            this.view = view;
            this.out = out;
            space = new SightSpace(view);
            brush = new FaceBrush(paint, out, tally);
            whole = new ScreenPolygon(view);
            order = started(pulse);
        }

        private OrderWalk started(Runnable pulse) {
            try {
                return method.walk(space.sight(), this::paint, pulse);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(
                        "the faces, as this view shows them, cannot be put in order, but a depth"
                                + " buffer may draw them: "
                                + e.getMessage(),
                        e);
            }
        }

        /** Fills the pixels that the whole face covers on the piece's sides of all its cuts. */
        private void paint(int polygon, double[] corners) {
            face = space.face(polygon);
            sightCorners = corners;
            cuts = order.cuts().stream().map(space::line).toArray(CutLine[]::new);
            whole.load(view, face);
            if (cuts.length == 0) brush.fill(whole, face);
            else whole.fill(out.width(), out.height(), cut);
        }

        private void fillCut(int y, int from, int to) {
            int first = from;
            int end = to;
            for (CutLine line : cuts) {
                int begin = line.from(y, first, end);
                end = line.to(y, first, end);
                first = begin;
                if (first >= end) return;
            }
            brush.span(face, y, first, end);
        }

        @Override
        public boolean advance() {
            return order.advance();
        }

        @Override
        public Optional<double[]> piece() {
            boolean cut = order.step().kind() == OrderStep.OrderStepKind.PAINT && cuts.length > 0;
            return cut ? Optional.of(space.toPixels(sightCorners)) : Optional.empty();
        }

        @Override
        public VisibilityStep step() {
            OrderStep step = order.step();
            int face = space.face(step.polygon());
            int against = space.face(step.against());
            return switch (step.kind()) {
                case PAINT -> new VisibilityStep.FaceDrawn(face, step.value());
                case MOVE -> new VisibilityStep.FaceMoved(face, against, step.value());
                case CUT -> new VisibilityStep.FaceCut(face, against, step.value());
            };
        }

        @Override
        public VisibilityWork work() {
            Map<String, Long> counted = order.operations();
            tally.comparisons = counted.getOrDefault("comparisons", 0L);
            tally.splits = counted.getOrDefault("splits", 0L);
            return tally.work();
        }
    }
}
