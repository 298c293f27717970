package rasterlab.exercises.judging;

import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.engine.study.Topic;

/**
 * Tells whether two wrong answers of triangles make the same mistake although they cut a polygon
 * otherwise: both are right as soon as each triangle goes round the other way.
 */
final class SameTriangles {
    private SameTriangles() {}

    static <I> boolean areTurnedOver(
            Topic<?, I, ?> topic, I input, Triangles one, Triangles other) {
        return isTurnedOver(topic, input, one) && isTurnedOver(topic, input, other);
    }

    @SuppressWarnings("unchecked") // its outputs are triangles
    private static <I> boolean isTurnedOver(Topic<?, I, ?> topic, I input, Triangles all) {
        if (all.size() == 0) return false;
        var triangles = (Topic<?, I, Triangles>) topic;
        Triangles right = triangles.exact(input, topic.mostItems());
        return triangles.correct(triangles.compare(input, right, turned(all)));
    }

    private static Triangles turned(Triangles all) {
        var triples = new int[3 * all.size()];
        for (int t = 0; t < all.size(); t++)
            for (int i = 0; i < 3; i++) triples[3 * t + i] = all.corner(t, 2 - i);
        return new Triangles(triples);
    }
}
