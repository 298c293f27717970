package rasterlab.engine.geometry.meeting;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/**
 * A plane and the lines to meet it: an input of topic {@code line-plane}.
 *
 * @param normal x, y, z of n
 * @param point x, y, z of a point a of the plane; no numbers where only c is known
 * @param c n·a, rounded where the point is known
 * @param from x, y, z of a point of each line
 * @param through x, y, z of another
 */
public record PlaneAndLines(
        double[] normal, double[] point, double c, double[][] from, double[][] through) {
    private static final double[] NO_POINT = {};

    /** Describes a plane of which only n and c are known. */
    public PlaneAndLines(Plane plane, List<Line> lines) {
        this(plane, Optional.empty(), lines);
    }

    /**
     * @param point of the plane, where one is known: c is rounded, so it need not be at a given one
     */
    public PlaneAndLines(Plane plane, Optional<Vector> point, List<Line> lines) {
        this(
                numbers(plane.normal()),
                point.map(PlaneAndLines::numbers).orElse(NO_POINT),
                plane.c(),
                lines.stream().map(line -> numbers(line.from())).toArray(double[][]::new),
                lines.stream().map(line -> numbers(line.through())).toArray(double[][]::new));
    }

    private static double[] numbers(Vector v) {
        return new double[] {v.x(), v.y(), v.z()};
    }

    private static Vector vector(double[] numbers) {
        return new Vector(numbers[0], numbers[1], numbers[2]);
    }

    public Plane plane() {
        return new Plane(vector(normal), c);
    }

    /**
     * @param index from 0 to the number of lines − 1
     */
    public Line line(int index) {
        return new Line(vector(from[index]), vector(through[index]));
    }

    /** The line where its points are no farther apart than a double tells. */
    Optional<Line> lineWithin(int index) {
        double apart = 0;
        for (int axis = 0; axis < 3; axis++)
            apart += Math.abs(through[index][axis] - from[index][axis]);
        return apart > 0 && Double.isFinite(apart) ? Optional.of(line(index)) : Optional.empty();
    }

    int size() {
        return from.length;
    }

    /** The point that is known of the plane. */
    public Optional<Vector> pointOfPlane() {
        return point.length == 0 ? Optional.empty() : Optional.of(vector(point));
    }

    /** The μ that a method, or the reference, finds for one line. */
    double mu(LinePlane method, int line) {
        return point.length == 0
                ? method.meets(normal, c, from[line], through[line])
                : method.meetsThrough(normal, point, from[line], through[line]);
    }

    @Override
    public String toString() {
        return from.length + " lines and the plane " + Arrays.toString(normal) + "·p = " + c;
    }
}
