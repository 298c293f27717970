package rasterlab.engine.transform.chain;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.chain.TransformTopic.Output;

/**
 * Points that go through a list of matrices, from outside: {@code matrices}, {@code points}; {@code
 * points} and {@code h} out.
 *
 * <p>All matrices have 4 rows and the points 3 numbers, or all have 3 and the points 2. A point may
 * have one number more, its homogeneous coordinate h, which is 0 at infinity. Without matrices
 * points stay where they are.
 */
final class TransformFormat extends Format<PointTransformer, Chain, Output> {
    private static final int MOST_MATRICES = 1_000;

    /** The most points after each of the matrices in one answer. */
    private static final int MOST_STEPPED = 1_000_000;

    private static final Field<List<double[][]>> MATRICES =
            Field.optional("matrices", Shape.list("matrices", new GivenMatrix(), 0, MOST_MATRICES));
    private static final Field<List<double[]>> POINTS =
            Field.required(
                            "points",
                            Shape.list("points", Shape.numbers(2, 4), 0, Shape.MOST_POINTS))
                    .as(FieldKind.POINTS);
    private static final Field<?> IMAGES =
            Field.required("points", Shape.list(EitherShape.orNull(Shape.numbersOrNull(2, 3))))
                    .as(FieldKind.POINTS);
    private static final Field<?> H =
            Field.required("h", Shape.list(EitherShape.orNull(Shape.number())));

    TransformFormat(Topic<PointTransformer, Chain, Output> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(MATRICES, POINTS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(IMAGES, H);
    }

    @Override
    public String reads() {
        return """
            {"matrices":[...], "points":[[x,y,z],...]}, each matrix by name as for topic \
            matrix or by its rows; a point may be homogeneous, [x,y,z,h], at infinity with h = 0""";
    }

    @Override
    public String answers() {
        return """
            {"points":[...], "h":[...]}, null where h is 0""";
    }

    @Override
    public Chain read(Given given) {
        List<double[][]> matrices = given.get(MATRICES, List.of());
        List<double[]> points = given.get(POINTS);
        int dimension = dimension(matrices, points);
        for (int i = 0; i < matrices.size(); i++)
            if (matrices.get(i).length != dimension + 1)
                throw new InvalidInput(
                        "/matrices/" + i,
                        "expected %d rows as /matrices/0 has, got %d"
                                .formatted(dimension + 1, matrices.get(i).length));
        var coordinates = new double[points.size() * dimension];
        var h = new double[points.size()];
        for (int i = 0; i < points.size(); i++) {
            double[] point = points.get(i);
            if (point.length != dimension && point.length != dimension + 1)
                throw new InvalidInput(
                        "/points/" + i,
                        "expected %d numbers, one less than the matrices have rows, or %d, with h, got %d"
                                .formatted(dimension, dimension + 1, point.length));
            System.arraycopy(point, 0, coordinates, i * dimension, dimension);
            h[i] = point.length == dimension ? 1 : point[dimension];
        }
        return new Chain(
                dimension,
                matrices.stream().map(TransformFormat::cells).toArray(double[][]::new),
                coordinates,
                h);
    }

    @Override
    protected Given given(Chain chain) {
        int dimension = chain.dimension();
        boolean plain = Arrays.stream(chain.h()).allMatch(h -> h == 1);
        var points = new ArrayList<double[]>();
        for (int i = 0; i < chain.h().length; i++) {
            int from = i * dimension;
            double[] point = Arrays.copyOfRange(chain.points(), from, from + dimension + 1);
            point[dimension] = chain.h()[i];
            points.add(plain ? Arrays.copyOf(point, dimension) : point);
        }
        List<double[][]> matrices =
                Arrays.stream(chain.matrices()).map(cells -> rows(cells, dimension + 1)).toList();
        return new Given().with(MATRICES, matrices).with(POINTS, points);
    }

    private static double[][] rows(double[] cells, int size) {
        var rows = new double[size][];
        for (int i = 0; i < size; i++)
            rows[i] = Arrays.copyOfRange(cells, i * size, (i + 1) * size);
        return rows;
    }

    private static int dimension(List<double[][]> matrices, List<double[]> points) {
        if (!matrices.isEmpty()) return matrices.get(0).length - 1;
        return points.isEmpty() ? 3 : Math.min(3, points.get(0).length);
    }

    private static double[] cells(double[][] rows) {
        var cells = new double[rows.length * rows.length];
        for (int i = 0; i < rows.length; i++)
            System.arraycopy(rows[i], 0, cells, i * rows.length, rows.length);
        return cells;
    }

    @Override
    public void write(Chain input, Output output, ValueSink out) throws IOException {
        int dimension = output.images().dimension();
        double[] all = output.images().coordinates();
        out.name(IMAGES.name());
        out.startArray();
        for (int i = 0; i < output.h().length; i++)
            if (output.images().has(i))
                out.numbers(Arrays.copyOfRange(all, i * dimension, (i + 1) * dimension));
            else out.nothing();
        out.endArray();
        out.numbers(H.name(), output.h());
    }

    @Override
    protected void check(Call<PointTransformer> call, Chain chain) {
        if (call.steps())
            RecordedSteps.requireAtMost(
                    MOST_STEPPED,
                    "points times matrices",
                    (long) chain.points().length / chain.dimension() * chain.matrices().length);
    }

    /** {@inheritDoc} With steps the points after each matrix of the list. */
    @Override
    protected Written answered(Call<PointTransformer> call, Chain chain) {
        if (!call.steps()) return super.answered(call, chain);
        var stages = new ArrayList<Output>();
        for (int i = 0; i <= chain.matrices().length; i++)
            stages.add(
                    recorded(
                            call,
                            new Chain(
                                    chain.dimension(),
                                    Arrays.copyOf(chain.matrices(), i),
                                    chain.points(),
                                    chain.h())));
        Output last = stages.get(stages.size() - 1);
        return answer(chain, last, null, out -> writeStages(chain, stages, out));
    }

    private void writeStages(Chain chain, List<Output> stages, ValueSink out) throws IOException {
        out.name("steps");
        out.startArray();
        for (int i = 0; i < stages.size(); i++) {
            out.startObject();
            out.whole("matrices", i);
            write(chain, stages.get(i), out);
            out.endObject();
        }
        out.endArray();
    }
}
