package rasterlab.app.visibility.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Painting;
import rasterlab.engine.visibility.order.Sight;

/**
 * Polygons of a magnitude that no eye can look at, in the order that a method finds for them as
 * they are.
 *
 * @param pieces the farthest first, in the sight's own numbers
 * @param exponent of the power of two that brings them into reach
 */
record PaintedSight(List<Painting.Piece> pieces, int exponent, List<ShownDifference> differences) {
    /** World units from the eye to the middle. */
    private static final double AWAY = 512;

    /**
     * @param rho mean depth of the corners
     */
    static PaintedSight of(Sight sight, String method, double rho) {
        var topic = new DepthOrderTopic();
        var differences = new ArrayList<ShownDifference>();
        List<Painting.Piece> pieces = topic.exact(sight, topic.mostItems()).pieces();
        if (method.isEmpty())
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.PAINTED_AS_GIVEN));
        else {
            try {
                pieces =
                        topic.record(
                                        topic.method(method).implementation(),
                                        sight,
                                        topic.mostItems())
                                .pieces();
                differences.add(
                        ShownDifference.of(
                                ShownDifference.ShownDifferenceKind.PAINTED_IN_ORDER, method));
            } catch (IllegalArgumentException refused) {
                differences.add(
                        ShownDifference.of(ShownDifference.ShownDifferenceKind.PAINTED_AS_GIVEN));
            }
        }
        int exponent = Math.getExponent(AWAY / rho);
        differences.add(ShownDifference.of(ShownDifference.ShownDifferenceKind.SCALED, exponent));
        return new PaintedSight(pieces, exponent, differences);
    }

    /** A piece as seen from the eye, brought into reach. */
    double[] scaled(Painting.Piece piece, double[] eye) {
        return Arrays.stream(TopicView.minus(piece.corners(), eye))
                .map(x -> Math.scalb(x, exponent))
                .toArray();
    }
}
