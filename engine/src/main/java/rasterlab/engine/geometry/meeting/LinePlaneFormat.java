package rasterlab.engine.geometry.meeting;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.contract.LinePlane;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** A line and a plane from outside; where they meet, and how they lie to each other, out. */
final class LinePlaneFormat extends Format<LinePlane, PlaneAndLines, Meetings> {
    private static final Field<double[]> LINE = Field.required("line", Shape.points(3, 2, 2));
    private static final Field<double[]> PLANE = Field.optional("plane", Shape.points(3, 3, 3));
    private static final Field<double[]> NORMAL = Field.optional("normal", Shape.numbers(3, 3));
    private static final Field<double[]> POINT = Field.optional("point", Shape.numbers(3, 3));
    private static final Shape<Double> NUMBER = EitherShape.orNull(Shape.number());

    LinePlaneFormat(Topic<LinePlane, PlaneAndLines, Meetings> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(LINE, PLANE, NORMAL, POINT);
    }

    @Override
    protected List<List<Field<?>>> groups() {
        return List.of(List.of(PLANE), List.of(NORMAL, POINT));
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(
                Field.required("mu", NUMBER),
                Field.optional("point", Shape.numbers(3, 3)),
                Field.optional("part", Shape.word(List.of("behind", "between", "beyond"))),
                Field.required("angle", NUMBER).in("degrees"),
                Field.required("cosines", Shape.numbers(3, 3)),
                Field.required("projection", NUMBER));
    }

    @Override
    public boolean hasSteps() {
        return false;
    }

    @Override
    public String reads() {
        return """
            {"line":[[x,y,z],[x,y,z]]} with "plane":[[x,y,z],[x,y,z],[x,y,z]] or \
            "normal":[a,b,c] and "point":[x,y,z]""";
    }

    @Override
    public String answers() {
        return """
            {"mu":m, "point":[x,y,z], "part":"behind", "between" or "beyond", \
            "angle":degrees, "cosines":[...] of the line, \
            "projection": its length along the normal}; where mu is no number, it is null and \
            point and part are missing""";
    }

    @Override
    public PlaneAndLines read(Given given) {
        Vector normal = plane(given).normal();
        double[] point = point(given);
        Line line = line(given);
        return new PlaneAndLines(
                numbers(normal),
                point,
                normal.dot(vector(point, 0)),
                new double[][] {numbers(line.from())},
                new double[][] {numbers(line.through())});
    }

    @Override
    protected Given given(PlaneAndLines input) {
        if (input.size() != 1)
            throw new IllegalArgumentException("one line is told at a time, got " + input.size());
        if (input.point().length == 0)
            throw new IllegalArgumentException("a plane is told by a point of it, not by c");
        var line =
                DoubleStream.concat(
                        Arrays.stream(input.from()[0]), Arrays.stream(input.through()[0]));
        return new Given()
                .with(LINE, line.toArray())
                .with(NORMAL, input.normal())
                .with(POINT, input.point());
    }

    /** {@inheritDoc} One for each line. */
    @Override
    public List<PlaneAndLines> singles(PlaneAndLines input) {
        return IntStream.range(0, input.size())
                .mapToObj(
                        i ->
                                new PlaneAndLines(
                                        input.normal(),
                                        input.point(),
                                        input.c(),
                                        new double[][] {input.from()[i]},
                                        new double[][] {input.through()[i]}))
                .toList();
    }

    /** {@inheritDoc} A μ that is no number, as the textbook's can be, names no point. */
    @Override
    public void write(PlaneAndLines input, Meetings meetings, ValueSink out) throws IOException {
        double mu = meetings.mu(0);
        out.number("mu", mu);
        if (!meetings.hasPoint(0)) return;
        out.numbers("point", meetings.point(0));
        out.text("part", Line.part(mu).name().toLowerCase(Locale.ROOT));
    }

    @Override
    public Supplier<Written> prepared(Call<LinePlane> call, Given given) {
        Line line = line(given);
        Plane plane = plane(given);
        PlaneAndLines input = read(given);
        return () -> answered(call, input, line, plane);
    }

    @Override
    protected Written answered(Call<LinePlane> call, PlaneAndLines input) {
        var line = new Line(vector(input.from()[0], 0), vector(input.through()[0], 0));
        return answered(call, input, line, new Plane(vector(input.normal(), 0), 0));
    }

    /**
     * @throws IllegalArgumentException if one of the numbers is out of range
     */
    private Written answered(Call<LinePlane> call, PlaneAndLines input, Line line, Plane plane) {
        double mu = input.mu(call.method(), 0);
        double[] point = Double.isFinite(mu) ? numbers(line.at(mu)) : null;
        double angle = plane.angleWith(line);
        double[] cosines = numbers(line.direction().unit());
        double projection = line.direction().projectedOn(plane.normal());
        return answer(
                input,
                Meetings.ofOne(mu, point),
                out -> {
                    out.number("angle", angle);
                    out.numbers("cosines", cosines);
                    out.number("projection", projection);
                },
                null);
    }

    private static Line line(Given given) {
        double[] ends = given.get(LINE);
        try {
            return new Line(vector(ends, 0), vector(ends, 3));
        } catch (IllegalArgumentException e) {
            throw given.invalid("line", e.getMessage());
        }
    }

    /** A plane parallel to the given one: methods get its point, so that no c is rounded here. */
    private static Plane plane(Given given) {
        boolean byNormal = given.has(NORMAL) && given.has(POINT);
        if (given.has(NORMAL) != given.has(POINT) || byNormal == given.has(PLANE))
            throw new InvalidInput(
                    "/",
                    "expected either plane, or normal and point, got "
                            + String.join(", ", new TreeSet<>(given.names())));
        try {
            if (byNormal) return new Plane(vector(given.get(NORMAL), 0), 0);
            double[] p = given.get(PLANE);
            return new Plane(Plane.normal(vector(p, 0), vector(p, 3), vector(p, 6)), 0);
        } catch (IllegalArgumentException e) {
            throw byNormal ? given.invalid(e) : given.invalid("plane", e.getMessage());
        }
    }

    /** A point of the plane: the given one, or the second of three. */
    private static double[] point(Given given) {
        return given.has(POINT) ? given.get(POINT) : Arrays.copyOfRange(given.get(PLANE), 3, 6);
    }

    private static Vector vector(double[] numbers, int from) {
        return new Vector(numbers[from], numbers[from + 1], numbers[from + 2]);
    }

    private static double[] numbers(Vector v) {
        return new double[] {v.x(), v.y(), v.z()};
    }
}
