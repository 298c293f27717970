package rasterlab.engine.border;

import java.util.Arrays;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Sight;

/** Triangles and rectangles in space, and eyes that look at them. */
final class OrderBorders {
    /** Coordinates before all are multiplied by the same: mostly narrower ones are refused. */
    private static final double LARGEST = 1000;

    private static final double[] SCALES = {1, 1, 1e200, 1e-200};

    private OrderBorders() {}

    static Border<?, ?, ?> all() {
        return Border.of(
                        new DepthOrderTopic(),
                        OrderBorders::sight,
                        (method, sight, message) ->
                                method.equals("newell")
                                        && (message.contains("in front of the eye")
                                                || message.contains("in the middle of the box")))
                .slow(0.3);
    }

    private static Sight sight(Draws draws) {
        double scale = SCALES[draws.pick(SCALES.length)];
        var polygons = new double[2 + draws.pick(3)][];
        for (int k = 0; k < polygons.length; k++)
            polygons[k] = draws.coin() ? rectangle(draws) : coordinates(draws, 9);
        double[] eye = coordinates(draws, 3);
        OrderRange.require(polygons, eye);
        return new Sight(
                Arrays.stream(polygons).map(xyz -> times(xyz, scale)).toArray(double[][]::new),
                times(eye, scale));
    }

    private static double[] coordinates(Draws draws, int count) {
        var coordinates = new double[count];
        for (int i = 0; i < count; i++) coordinates[i] = draws.number(-LARGEST, LARGEST);
        return coordinates;
    }

    /** A rectangle at right angles to an axis. */
    private static double[] rectangle(Draws draws) {
        int axis = draws.pick(3);
        double depth = draws.number(-LARGEST, LARGEST);
        double[] ends = coordinates(draws, 4);
        var xyz = new double[12];
        for (int i = 0; i < 4; i++) {
            xyz[3 * i + axis] = depth;
            xyz[3 * i + (axis + 1) % 3] = ends[i == 1 || i == 2 ? 1 : 0];
            xyz[3 * i + (axis + 2) % 3] = ends[2 + i / 2];
        }
        return xyz;
    }

    private static double[] times(double[] values, double factor) {
        return Arrays.stream(values).map(value -> factor * value).toArray();
    }
}
