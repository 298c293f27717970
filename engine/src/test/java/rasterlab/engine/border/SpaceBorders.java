package rasterlab.engine.border;

import java.util.List;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;

/** Points of space to turn and to see. */
final class SpaceBorders {
    /** Coordinates beyond are refused by contract. */
    private static final double LARGEST = 0x1p1000;

    private SpaceBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(Border.of(new AxisTopic(), SpaceBorders::turn));
    }

    private static AxisTurn turn(Draws draws) {
        double[] direction = draws.numbers(3);
        if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
            throw new IllegalArgumentException("no direction");
        double degrees = draws.number();
        return new AxisTurn(coordinates(draws, 3), direction, degrees, coordinates(draws, 3));
    }

    private static double[] coordinates(Draws draws, int count) {
        var coordinates = new double[count];
        for (int i = 0; i < count; i++) coordinates[i] = draws.number(-LARGEST, LARGEST);
        return coordinates;
    }
}
