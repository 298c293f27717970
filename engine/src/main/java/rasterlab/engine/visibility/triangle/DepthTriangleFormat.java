package rasterlab.engine.visibility.triangle;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/**
 * Triangles with depths from outside: {@code triangles}, {@code size}, {@code background}; {@code
 * pixels} out.
 */
final class DepthTriangleFormat
        extends Format<DepthTriangleFiller, DepthTriangles, DepthTriangles.TrianglePicture> {
    private static final String DECISION = "depth − stored: the pixel is written below 0";
    private static final Shape<Double> PLACE =
            Shape.number(-DepthTriangleFiller.LARGEST, DepthTriangleFiller.LARGEST);
    private static final Shape<double[]> CORNER =
            Shape.describedByPlace(Shape.numbers(3, 3), PLACE, PLACE, Shape.number(0, 1));
    private static final Shape<double[]> TRIANGLE =
            Shape.described(Shape.points(3, 3, 3), Shape.list("points", CORNER, 3, 3));
    private static final Field<List<double[]>> TRIANGLES =
            Field.required("triangles", Shape.list("triangles", TRIANGLE, 1, DepthTriangles.MOST))
                    .as(FieldKind.POLYGONS);
    private static final Field<List<Integer>> SIZE =
            Field.required(
                            "size",
                            Shape.list(
                                    "whole numbers",
                                    Shape.whole(1, DepthTriangleFiller.LARGEST_SIDE),
                                    2,
                                    2))
                    .in("pixels");
    private static final Field<Double> BACKGROUND =
            Field.optional("background", Shape.number(0, 1));
    private static final Field<?> PIXELS =
            Field.required("pixels", Shape.list(Shape.numbersOrNull(4, 4))).as(FieldKind.PIXELS);

    DepthTriangleFormat(
            Topic<DepthTriangleFiller, DepthTriangles, DepthTriangles.TrianglePicture> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(TRIANGLES, SIZE, BACKGROUND);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(PIXELS);
    }

    @Override
    public String reads() {
        return """
        {"triangles":[[[x,y,depth],[x,y,depth],[x,y,depth]],...], "size":[w,h], \
        "background":depth}, x and y multiples of 1/256, depths from 0 to 1; without \
        background it is 1\
        """;
    }

    @Override
    public String answers() {
        return """
        {"pixels":[[x,y,k,depth],...]} row by row, where triangle k is seen, of n from 1 \
        to n\
        """;
    }

    @Override
    public DepthTriangles read(Given given) {
        List<double[]> triangles = given.get(TRIANGLES);
        List<Integer> size = given.get(SIZE);
        RecordedSteps.requireAtMost(
                "/size",
                DepthTriangles.MOST_LOOKS,
                "pixels times triangles",
                (long) size.get(0) * size.get(1) * triangles.size());
        try {
            return new DepthTriangles(
                    triangles, size.get(0), size.get(1), given.get(BACKGROUND, 1.0));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(DepthTriangles input) {
        return new Given()
                .with(TRIANGLES, input.triangles())
                .with(SIZE, List.of(input.width(), input.height()))
                .with(BACKGROUND, input.background());
    }

    @Override
    public void write(DepthTriangles input, DepthTriangles.TrianglePicture picture, ValueSink out)
            throws IOException {
        out.name(PIXELS.name());
        out.startArray();
        for (int at = 0; at < picture.shown().length; at++) {
            if (picture.shown()[at] == 0) continue;
            out.startArray();
            out.whole(at % picture.width());
            out.whole(at / picture.width());
            out.whole(picture.shown()[at]);
            out.number(picture.depths()[at]);
            out.endArray();
        }
        out.endArray();
    }

    /** A pixel of a triangle, and what was stored there before it. */
    private record Step(int triangle, int x, int y, double depth, double stored)
            implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("triangle", triangle);
            out.whole("x", x);
            out.whole("y", y);
            out.number("depth", depth);
            out.number("stored", stored);
            out.number("decision", depth - stored);
        }
    }

    @Override
    protected Written steps(Call<DepthTriangleFiller> call, DepthTriangles input) {
        call.stepped(RowsTriangle.class);
        double[] stored = DepthTriangles.TrianglePicture.empty(input).depths();
        var steps = new ArrayList<Step>();
        for (int t = 0; t < input.triangles().size(); t++) {
            var walk =
                    new RowsTriangle.DepthTriangleWalk(
                            input.axis(t, 0),
                            input.axis(t, 1),
                            input.axis(t, 2),
                            input.width(),
                            input.height());
            while (walk.advance()) {
                int at = walk.y() * input.width() + walk.x();
                RecordedSteps.add(
                        steps, new Step(t + 1, walk.x(), walk.y(), walk.depth(), stored[at]));
                stored[at] = Math.min(stored[at], walk.depth());
            }
        }
        return RecordedSteps.deciding(DECISION, steps);
    }
}
