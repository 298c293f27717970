package rasterlab.app.coordinates.figure;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.scene.House;
import rasterlab.engine.scene.Mesh;

/**
 * Points joined by edges.
 *
 * @param dimension numbers per point, 2 or 3
 * @param points numbers one after the other
 * @param edges each the numbers of two points, from 0
 */
public record Wireframe(int dimension, List<Double> points, List<Edge> edges) {
    /** Numbers of two points. */
    public record Edge(int from, int to) {}

    public Wireframe {
        Bounds.require("dimension", dimension, 2, 3);
        points = List.copyOf(points);
        edges = List.copyOf(edges);
    }

    /** The course's house in metres, its vertices 1 to 10 in their order. */
    public static Wireframe house() {
        return new Wireframe(3, list(House.vertices()), edges(House.mesh()));
    }

    /** The corner of a unit cube at the origin, its edges along the axes. */
    public static Wireframe cube() {
        double[] points = {
            0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, //
            0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1
        };
        int[][] faces = {
            {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}
        };
        return new Wireframe(3, list(points), edges(new Mesh(points, faces)));
    }

    /** The corner of the unit cube that is farthest from the origin. */
    public static Wireframe point() {
        return new Wireframe(3, List.of(1.0, 1.0, 1.0), List.of());
    }

    /** The unit square with a letter F in it, whose mirror image looks different. */
    public static Wireframe square() {
        return plane(
                new double[] {
                    0, 0, 1, 0, 1, 1, 0, 1, //
                    0.3, 0.2, 0.3, 0.8, 0.7, 0.8, 0.3, 0.5, 0.6, 0.5
                },
                new int[][] {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {7, 8}});
    }

    /** The triangle that the course turns by 90°. */
    public static Wireframe triangle() {
        return plane(new double[] {3, -1, 4, 1, 2, 1}, new int[][] {{0, 1}, {1, 2}, {2, 0}});
    }

    private static Wireframe plane(double[] points, int[][] pairs) {
        var edges = new ArrayList<Edge>();
        for (int[] pair : pairs) edges.add(new Edge(pair[0], pair[1]));
        return new Wireframe(2, list(points), edges);
    }

    private static List<Double> list(double[] numbers) {
        var list = new ArrayList<Double>();
        for (double number : numbers) list.add(number);
        return list;
    }

    /** Each edge of the faces once. */
    private static List<Edge> edges(Mesh mesh) {
        var edges = new LinkedHashSet<Edge>();
        for (int face = 0; face < mesh.faceCount(); face++)
            for (int i = 0; i < mesh.cornerCount(face); i++) {
                int a = mesh.corner(face, i);
                int b = mesh.corner(face, (i + 1) % mesh.cornerCount(face));
                edges.add(new Edge(Math.min(a, b), Math.max(a, b)));
            }
        return List.copyOf(edges);
    }

    public int size() {
        return points.size() / dimension;
    }

    /** A copy of all numbers. */
    public double[] numbers() {
        return points.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
