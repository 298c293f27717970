package rasterlab.app.coordinates.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.Wireframe;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.transform.PerspectiveAmount;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.StereoPair;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;

/**
 * The house at every stage.
 *
 * @param images of each stage in order, empty from where the method refuses
 * @param refusal why it refuses, "" where it does not
 * @param deviation of the last stage from the exact answer; none where it refuses
 * @param eyes the left and the right eye's images at the picture plane and on the screen, in that
 *     order; none unless two eyes look
 */
record ViewScene(
        ViewChoice choice,
        List<ViewStage> stages,
        List<StagePoints> images,
        String refusal,
        Optional<Deviation> deviation,
        List<StagePoints> eyes) {
    /** The points at one stage. */
    record StagePoints(List<Double> coordinates, List<Double> h) {
        static StagePoints of(TransformTopic.Output output) {
            return new StagePoints(list(output.images().coordinates()), list(output.h()));
        }

        private static List<Double> list(double[] numbers) {
            var list = new ArrayList<Double>();
            for (double number : numbers) list.add(number);
            return list;
        }

        double[] numbers() {
            return coordinates.stream().mapToDouble(Double::doubleValue).toArray();
        }

        double coordinate(int vertex, int axis) {
            return coordinates.get(3 * vertex + axis);
        }

        /** Whether the point lies before the eye, so that its image is to be drawn. */
        boolean inFront(int vertex) {
            return h.get(vertex) > 0;
        }

        /** How many points are at the eye or behind it. */
        long behind() {
            return h.stream().filter(each -> !(each > 0)).count();
        }
    }

    static final Wireframe HOUSE = Wireframe.house();

    static ViewScene of(TransformTopic topic, ViewChoice choice) {
        PointTransformer method = topic.method(choice.method()).implementation();
        List<ViewStage> stages = ViewStages.of(choice);
        var images = new ArrayList<StagePoints>();
        var cells = new ArrayList<double[]>();
        try {
            for (ViewStage stage : stages) {
                cells.addAll(Chains.cells(stage.calls()));
                images.add(StagePoints.of(Chains.images(method, 3, cells, HOUSE.numbers())));
            }
        } catch (IllegalArgumentException refused) {
            return new ViewScene(
                    choice, stages, images, refused.getMessage(), Optional.empty(), List.of());
        }
        return new ViewScene(
                choice,
                stages,
                images,
                "",
                Optional.of(deviation(topic, method, cells)),
                eyes(choice, stages));
    }

    private static Deviation deviation(
            TransformTopic topic, PointTransformer method, List<double[]> cells) {
        var chain = new Chain(3, cells.toArray(double[][]::new), HOUSE.numbers());
        return topic.compare(
                chain,
                topic.exact(chain, Integer.MAX_VALUE),
                topic.record(method, chain, Integer.MAX_VALUE));
    }

    private static List<StagePoints> eyes(ViewChoice choice, List<ViewStage> stages) {
        if (!choice.twoEyes()) return List.of();
        var camera =
                new SphericalView(
                        Math.toRadians(choice.number(ViewNumber.THETA)),
                        Math.toRadians(choice.number(ViewNumber.PHI)),
                        choice.number(ViewNumber.RHO));
        var pair = new StereoPair(camera, choice.number(ViewNumber.SEPARATION));
        var images = new ArrayList<StagePoints>();
        for (Matrix4d eye : List.of(pair.left(), pair.right())) {
            var cells = new ArrayList<>(Chains.cells(stages.get(1).calls()));
            cells.add(Chains.cells(eye));
            images.add(StagePoints.of(Chains.images(3, cells, HOUSE.numbers())));
            cells.addAll(Chains.cells(stages.get(4).calls()));
            images.add(StagePoints.of(Chains.images(3, cells, HOUSE.numbers())));
        }
        return images;
    }

    /** The images of a stage; empty where the method refused before. */
    Optional<StagePoints> image(int stage) {
        return stage < images.size() ? Optional.of(images.get(stage)) : Optional.empty();
    }

    /** All matrices from the object to a stage in one. */
    Matrix4d matrix(int stage) {
        var cells = new ArrayList<double[]>();
        for (ViewStage each : stages.subList(0, stage + 1))
            cells.addAll(Chains.cells(each.calls()));
        return Chains.product(cells);
    }

    /** Whether x, y, z of a stage before the projection are a right-handed frame. */
    boolean rightHanded(int stage) {
        return matrix(stage).determinant3x3() > 0;
    }

    /** z' of the nearest point before the eye and the depth of half of the object behind it. */
    record Depth(double nearest, double half) {
        double gamma() {
            return PerspectiveAmount.gamma(nearest, half);
        }
    }

    /**
     * The depths; empty where the view is not one by spherical coordinates, or a point is not
     * before it.
     */
    Optional<Depth> depth() {
        if (!choice.kind().spherical() || images.size() < 3) return Optional.empty();
        StagePoints eye = images.get(2);
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < HOUSE.size(); v++) {
            nearest = Math.min(nearest, eye.coordinate(v, 2));
            farthest = Math.max(farthest, eye.coordinate(v, 2));
        }
        return nearest > 0
                ? Optional.of(new Depth(nearest, (farthest - nearest) / 2))
                : Optional.empty();
    }
}
