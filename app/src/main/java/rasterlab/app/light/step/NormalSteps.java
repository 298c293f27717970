package rasterlab.app.light.step;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;

/**
 * The normals of the vertices that faces meet in, in the order of their numbers.
 *
 * @param vertices coordinates x, y, z of each
 * @param order number of the vertex of each step, from 0
 * @param mine x, y, z of each vertex's normal by the program
 * @param right the same as is right
 */
public record NormalSteps(double[] vertices, int[] order, double[] mine, double[] right)
        implements OwnSteps {
    /**
     * Normals by a program; a vertex of no triangle is no step.
     *
     * @param triangles three numbers of vertices each
     */
    public static NormalSteps of(
            double[] vertices, int[] triangles, double[] mine, double[] right) {
        int[] order = Arrays.stream(triangles).distinct().sorted().toArray();
        return new NormalSteps(vertices, order, mine, right);
    }

    @Override
    public int count() {
        return order.length;
    }

    @Override
    public double[] point(int step) {
        return Arrays.copyOfRange(vertices, 3 * vertex(step), 3 * vertex(step) + 3);
    }

    /** The number of the vertex that a step is about. */
    public int vertex(int step) {
        return order[step - 1];
    }

    @Override
    public String words(int step, Texts texts) {
        int at = vertex(step);
        return texts.text(
                "own.step.normal",
                step,
                count(),
                at,
                numbers(mine, at, texts),
                numbers(right, at, texts));
    }

    private static String numbers(double[] normals, int at, Texts texts) {
        return IntStream.range(3 * at, 3 * at + 3)
                .mapToObj(i -> Shown.number(normals[i], 3, texts.locale()))
                .collect(Collectors.joining(Shown.apart(texts.locale()), "(", ")"));
    }
}
