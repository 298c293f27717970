package rasterlab.app.row;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.filter.FilteredPixels;

/** Footprints as the colours that they are filtered to, above the picture that they lie on. */
final class FilterKind extends RowKind<TextureFilter, FilteredPixels, double[]> {
    private static final String[] CHANNELS = {"A", "R", "G", "B"};

    /** Levels beyond which the topic calls a colour wrong. */
    private static final double USABLE = 8;

    FilterKind() {
        this(new OwnMethods());
    }

    FilterKind(OwnMethods own) {
        super(own.in(new FilterTopic()));
    }

    @Override
    boolean asksSteps() {
        return true;
    }

    @Override
    int pixels(FilteredPixels pixels) {
        return pixels.count();
    }

    /** Writes the greys of a picture, whose alpha is not told outside. */
    @Override
    String json(FilteredPixels pixels) {
        return CommandInput.of(
                out -> {
                    out.name("picture");
                    out.startArray();
                    for (int row = pixels.height() - 1; row >= 0; row--)
                        out.wholes(grays(pixels, row));
                    out.endArray();
                    out.points(
                            "pixels",
                            pixels.footprints(),
                            pixels.footprints().length / pixels.count());
                });
    }

    private static int[] grays(FilteredPixels pixels, int row) {
        return Arrays.stream(pixels.argb(), row * pixels.width(), (row + 1) * pixels.width())
                .map(argb -> argb & 255)
                .toArray();
    }

    @Override
    List<RowScene.ColorBand> right(FilteredPixels pixels, double[] exact) {
        return List.of(band("right", exact));
    }

    @Override
    List<RowScene.ColorBand> made(FilteredPixels pixels, double[] actual) {
        return List.of(band("method", actual));
    }

    /** Levels are alpha, red, green and blue of each pixel. */
    private static RowScene.ColorBand band(String key, double[] levels) {
        return new RowScene.ColorBand(
                key,
                IntStream.range(0, levels.length / 4)
                        .map(
                                i ->
                                        level(levels[4 * i]) << 24
                                                | level(levels[4 * i + 1]) << 16
                                                | level(levels[4 * i + 2]) << 8
                                                | level(levels[4 * i + 3]))
                        .toArray());
    }

    private static int level(double level) {
        return (int) Math.round(level);
    }

    @Override
    double error(FilteredPixels pixels, double[] exact, double[] actual, int pixel) {
        return IntStream.range(4 * pixel, 4 * pixel + 4)
                .mapToDouble(c -> Math.abs(exact[c] - actual[c]))
                .max()
                .orElse(0);
    }

    @Override
    boolean wrong(FilteredPixels pixels, double[] exact, double[] actual, int pixel) {
        return error(pixels, exact, actual, pixel) > USABLE;
    }

    @Override
    RowScene.PixelNumbers numbers(
            FilteredPixels pixels, double[] exact, Optional<double[]> actual, int pixel) {
        var headings = new ArrayList<>(List.of("channel", "right"));
        if (actual.isPresent()) headings.add("method");
        var lines = new ArrayList<RowScene.NumberRow>();
        for (int c = 1; c < CHANNELS.length; c++) {
            double right = exact[4 * pixel + c];
            lines.add(
                    actual.isEmpty()
                            ? new RowScene.NumberRow(CHANNELS[c], right)
                            : new RowScene.NumberRow(
                                    CHANNELS[c], right, actual.get()[4 * pixel + c]));
        }
        return new RowScene.PixelNumbers(headings, lines);
    }

    @Override
    Optional<RowScene.FilteredImage> image(FilteredPixels pixels) {
        return Optional.of(
                new RowScene.FilteredImage(
                        pixels.width(), pixels.height(), pixels.argb(), pixels.footprints()));
    }
}
