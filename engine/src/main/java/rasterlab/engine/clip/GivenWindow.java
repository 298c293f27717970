package rasterlab.engine.clip;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.MadeShape;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;

/**
 * A window to clip by from outside: [xmin,ymin,xmax,ymax], or the corners of a convex polygon.
 *
 * @param upright whether it is a rectangle by its sides
 * @param numbers the sides, or x and y of each corner in turn; not yet known to be convex
 */
public record GivenWindow(boolean upright, double[] numbers) {
    private static final int MOST_CORNERS = 1_000;

    public static final Field<GivenWindow> FIELD =
            Field.required("window", new Made()).as(FieldKind.WINDOW);

    /** A side, or a corner. */
    private static final class Part extends EitherShape<double[]> {
        private static final Shape<double[]> CORNER = Shape.numbers(2, 2);
        private static final Shape<Double> SIDE = Shape.number();

        Part() {
            super(CORNER, SIDE);
        }

        @Override
        public double[] read(ValueSource in) throws IOException {
            return in.startsArray() ? CORNER.read(in) : new double[] {SIDE.read(in)};
        }

        @Override
        public void write(double[] part, ValueSink out) throws IOException {
            if (part.length == 1) SIDE.write(part[0], out);
            else CORNER.write(part, out);
        }
    }

    /** Parts of one kind. */
    private static final class Made extends MadeShape<List<double[]>, GivenWindow> {
        Made() {
            super(
                    Shape.list(
                            "points of 2 numbers each, or [xmin,ymin,xmax,ymax]",
                            new Part(),
                            3,
                            MOST_CORNERS));
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            out.startObject();
            out.name("anyOf");
            out.startArray();
            Shape.numbers(4, 4).schema(out);
            Shape.points(2, 3, MOST_CORNERS).schema(out);
            out.endArray();
            out.endObject();
        }

        @Override
        protected GivenWindow made(List<double[]> parts) {
            int width = parts.get(0).length;
            if (parts.stream().anyMatch(part -> part.length != width)
                    || width == 1 && parts.size() != 4)
                throw new IllegalArgumentException(
                        "expected [xmin,ymin,xmax,ymax] or an array of points of 2 numbers each");
            double[] n = parts.stream().flatMapToDouble(Arrays::stream).toArray();
            if (width == 1) RectangleSides.requireOrdered(n[0], n[1], n[2], n[3]);
            return new GivenWindow(width == 1, n);
        }

        @Override
        protected List<double[]> value(GivenWindow window) {
            return PartFormat.rows(window.numbers(), window.upright() ? 1 : 2);
        }
    }
}
