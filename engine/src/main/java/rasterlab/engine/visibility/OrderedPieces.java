package rasterlab.engine.visibility;

import java.util.Map;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.OrderStep;
import rasterlab.engine.visibility.order.OrderWalk;
import rasterlab.engine.visibility.order.SteppedOrder;

/**
 * Faces and pieces of them in an order in which none hides one after it, each painted over the ones
 * before: a method of topic {@code depth-order}, in {@link SightSpace}.
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
        return new Walk(view, paint, out);
    }

    private final class Walk implements VisibilityWalk {
        private final ViewedMesh view;
        private final SightSpace space;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final OrderWalk order;
        private final ScreenPolygon whole;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            space = new SightSpace(view);
            brush = new FaceBrush(paint, out, tally);
            whole = new ScreenPolygon(view.mesh().mostCorners());
            order = started();
        }

        private OrderWalk started() {
            try {
                return method.walk(space.sight(), this::paint);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(
                        "the faces, as this view shows them, cannot be put in order: "
                                + e.getMessage(),
                        e);
            }
        }

        private void paint(int polygon, double[] corners) {
            int face = space.face(polygon);
            if (space.whole(polygon, corners)) {
                whole.load(view, face);
                brush.fill(whole, face);
                return;
            }
            double[] piece = space.toView(corners);
            var cut = new ScreenPolygon(piece.length / 3);
            cut.load(view, piece);
            brush.fill(cut, face);
        }

        @Override
        public boolean advance() {
            return order.advance();
        }

        @Override
        public VisibilityStep step() {
            OrderStep step = order.step();
            int face = space.face(step.polygon());
            int against = space.face(step.against());
            return switch (step.kind()) {
                case PAINT -> new VisibilityStep.Drawn(face, step.value());
                case MOVE -> new VisibilityStep.Moved(face, against, step.value());
                case CUT -> new VisibilityStep.Cut(face, against, step.value());
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
