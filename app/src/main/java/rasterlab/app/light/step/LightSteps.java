package rasterlab.app.light.step;

import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.color.Levels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.SeenPoint;

/**
 * The light at points of a body, face by face.
 *
 * @param points that were asked for
 * @param order number of the point of each step, from 0
 * @param mine red, green and blue of each point by the program
 * @param right the same as is right
 * @param painted makes a picture of the body from the colour of each point
 */
public record LightSteps(
        List<SeenPoint> points, int[] order, double[] mine, double[] right, Painted painted)
        implements OwnSteps {
    /** Paints a body, each square of pixels in the colour of its point. */
    @FunctionalInterface
    public interface Painted {
        /**
         * @param color of a point by its number, as ARGB
         */
        Raster of(IntUnaryOperator color);
    }

    /** Light by a program, in the order of the faces, and within one in that of the points. */
    public static LightSteps of(
            List<SeenPoint> points, double[] mine, double[] right, Painted painted) {
        int[] order =
                IntStream.range(0, points.size())
                        .boxed()
                        .sorted(
                                (a, b) ->
                                        Integer.compare(points.get(a).face(), points.get(b).face()))
                        .mapToInt(Integer::intValue)
                        .toArray();
        return new LightSteps(points, order, mine, right, painted);
    }

    @Override
    public int count() {
        return order.length;
    }

    @Override
    public double[] point(int step) {
        return points.get(order[step - 1]).position();
    }

    @Override
    public String words(int step, Texts texts) {
        int at = order[step - 1];
        return texts.text(
                "own.step.light",
                step,
                count(),
                points.get(at).face() + 1,
                shares(mine, at, texts),
                shares(right, at, texts),
                Shown.number(levels(at), 1, texts.locale()));
    }

    private static String shares(double[] light, int at, Texts texts) {
        return IntStream.range(3 * at, 3 * at + 3)
                .mapToObj(i -> Shown.number(light[i], 3, texts.locale()))
                .collect(Collectors.joining(Shown.apart(texts.locale()), "(", ")"));
    }

    /** The largest difference of a point's shares, in levels of 255. */
    private double levels(int at) {
        double most = 0;
        for (int c = 3 * at; c < 3 * at + 3; c++)
            most = Math.max(most, Levels.HIGHEST * Math.abs(mine[c] - right[c]));
        return most;
    }

    /**
     * A picture of the answers up to a step.
     *
     * @param color of a point by its number
     * @param open colour of the points of later steps
     */
    public Raster picture(int step, IntUnaryOperator color, int open) {
        var colors = new int[count()];
        for (int k = 0; k < count(); k++)
            colors[order[k]] = k < step ? color.applyAsInt(order[k]) : open;
        return painted.of(k -> colors[k]);
    }
}
