package rasterlab.engine.geometry.meeting;

import java.util.Arrays;
import java.util.List;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/**
 * A plane and the lines to meet it: an input of topic {@code line-plane}.
 *
 * @param normal x, y, z of n
 * @param c n·a for any point a of the plane
 * @param from x, y, z of a point of each line
 * @param through x, y, z of another
 */
public record PlaneAndLines(double[] normal, double c, double[][] from, double[][] through) {
    public PlaneAndLines(Plane plane, List<Line> lines) {
        this(
                numbers(plane.normal()),
                plane.c(),
                lines.stream().map(line -> numbers(line.from())).toArray(double[][]::new),
                lines.stream().map(line -> numbers(line.through())).toArray(double[][]::new));
    }

    /** Answers of a method, or of the reference. */
    @FunctionalInterface
    interface Answers {
        double mu(double[] normal, double c, double[] from, double[] through);
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

    int size() {
        return from.length;
    }

    double mu(Answers answers, int line) {
        return answers.mu(normal, c, from[line], through[line]);
    }

    @Override
    public String toString() {
        return from.length + " lines and the plane " + Arrays.toString(normal) + "·p = " + c;
    }
}
