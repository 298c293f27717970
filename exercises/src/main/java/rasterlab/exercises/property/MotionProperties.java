package rasterlab.exercises.property;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.axis.AxisTurn;
import rasterlab.engine.transform.rotate.Turns;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;

/** Properties of motions: they go back, and keep all distances. */
final class MotionProperties {
    static final List<Property<?, Images>> ALL =
            List.of(
                    Property.<Turns, Images>always(
                            "rotate",
                            "there-and-back",
                            Relation.followed(
                                    (turns, images) ->
                                            new Turns(
                                                    -turns.degrees(),
                                                    turns.times(),
                                                    images.coordinates()),
                                    (turns, images) -> new Images(turns.points(), 2))),
                    Property.<AxisTurn, Images>always(
                            "rotate-axis",
                            "there-and-back",
                            Relation.followed(
                                    (turn, images) ->
                                            new AxisTurn(
                                                    turn.through(),
                                                    turn.direction(),
                                                    -turn.degrees(),
                                                    images.coordinates()),
                                    (turn, images) -> new Images(turn.points(), 3))),
                    Property.<ViewTask, Images>always(
                            "view", "orthogonality", new DistancesKept()));

    private MotionProperties() {}

    /**
     * The relation that the images of two points are as far apart as these: so it is where the axes
     * have length 1 and are at right angles.
     */
    private static final class DistancesKept implements Relation<ViewTask, Images> {
        @Override
        public List<ViewTask> furtherInputs(ViewTask look, Images images) {
            return List.of();
        }

        @Override
        public Optional<Broken<ViewTask, Images>> broken(
                AnsweredInput<ViewTask, Images> first,
                List<AnsweredInput<ViewTask, Images>> beside,
                Equivalence<ViewTask, Images> alike) {
            double[] points = first.input().points();
            double[] images = first.output().coordinates();
            if (images.length != points.length) return Optional.empty();
            for (int a = 0; a < points.length; a += 3)
                for (int b = a + 3; b < points.length; b += 3) {
                    Images wanted = moved(images, a, b, apart(points, a, b));
                    if (!alike.test(first.input(), wanted, first.output()))
                        return Optional.of(new Broken<>(first, wanted));
                }
            return Optional.empty();
        }

        private static double apart(double[] points, int a, int b) {
            return Math.hypot(
                    Math.hypot(points[b] - points[a], points[b + 1] - points[a + 1]),
                    points[b + 2] - points[a + 2]);
        }

        /** The second of two images brought so far from the first, straight away from it. */
        private static Images moved(double[] images, int a, int b, double wanted) {
            double[] moved = images.clone();
            double is = apart(images, a, b);
            for (int i = 0; i < 3; i++) {
                double away = is > 0 ? (images[b + i] - images[a + i]) / is : i == 0 ? 1 : 0;
                moved[b + i] = images[a + i] + away * wanted;
            }
            return new Images(moved, 3);
        }
    }
}
