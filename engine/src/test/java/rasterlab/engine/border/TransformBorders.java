package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.engine.transform.view.ViewTopic;

/** Points to move and the matrices, angles and axes that move them. */
final class TransformBorders {
    /** Coordinates beyond are refused by contract. */
    private static final double LARGEST = 0x1p1000;

    private static final MatrixTopic MATRIX = new MatrixTopic();

    private TransformBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(MATRIX, TransformBorders::matrix, TransformBorders::noMatrix),
                Border.of(
                        new TransformTopic(),
                        TransformBorders::chain,
                        (method, chain, message) -> !Cancelling.isMiddling(chain)),
                Border.of(new ViewTopic(), TransformBorders::look),
                Border.of(new RotateTopic(), TransformBorders::turns),
                Border.of(new AxisTopic(), TransformBorders::turn));
    }

    private static MatrixCall matrix(Draws draws) {
        List<NamedMatrix> all = NamedMatrices.all();
        NamedMatrix matrix = all.get(draws.pick(all.size()));
        var numbers = new ArrayList<Double>();
        for (MatrixParameter parameter : matrix.parameters())
            for (int i = 0; i < parameter.size(); i++) {
                double number = inRange(draws, parameter.range());
                parameter.require(number, i);
                numbers.add(number);
            }
        return new MatrixCall(matrix.name(), numbers);
    }

    private static double inRange(Draws draws, MatrixParameter.ParameterRange range) {
        return switch (range) {
            case ANY, DEGREES, NOT_ZERO -> draws.number();
            case POSITIVE -> draws.number(Double.MIN_VALUE, Double.MAX_VALUE);
            case INSIDE_UNIT -> draws.number(Double.MIN_VALUE, Math.nextDown(1.0));
            case UNIT -> draws.number(0, 1);
            case HALF_TURN -> draws.number(Double.MIN_VALUE, Math.nextDown(180.0));
        };
    }

    /** A cell too large for a double, or parameters of which there is no such matrix. */
    private static boolean noMatrix(String method, MatrixCall call, String message) {
        if (!message.contains("too large for a double")) return true;
        return Arrays.stream(MATRIX.exact(call, 1))
                .flatMapToDouble(Arrays::stream)
                .anyMatch(cell -> Math.abs(cell) > 0x1p1000);
    }

    private static Chain chain(Draws draws) {
        int dimension = 2 + draws.pick(2);
        var matrices = new double[1 + draws.pick(3)][];
        for (int i = 0; i < matrices.length; i++) matrices[i] = cells(draws, dimension + 1);
        double[] h = {draws.pick(2) == 0 ? 1 : draws.number(-LARGEST, LARGEST)};
        var chain = new Chain(dimension, matrices, coordinates(draws, dimension), h);
        if (Cancelling.moreThanHalf(chain))
            throw new IllegalArgumentException("more than half of the digits cancel");
        return chain;
    }

    /** The identity with some cells changed, or any cells. */
    private static double[] cells(Draws draws, int size) {
        if (draws.pick(4) == 3) return draws.numbers(size * size);
        var cells = new double[size * size];
        for (int i = 0; i < size; i++) cells[i * size + i] = 1;
        for (int i = draws.pick(size); i >= 0; i--) cells[draws.pick(size * size)] = draws.number();
        return cells;
    }

    private static ViewTask look(Draws draws) {
        return new ViewTask(
                draws.number(),
                draws.number(),
                draws.number(Double.MIN_VALUE, LARGEST),
                coordinates(draws, 3));
    }

    private static Turns turns(Draws draws) {
        return new Turns(
                draws.number(), draws.whole(0, PlaneRotation.MOST_TIMES), coordinates(draws, 2));
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
