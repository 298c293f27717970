package rasterlab.app.row;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.depth.DepthRows;
import rasterlab.engine.visibility.depth.StoredDepths;

/**
 * Shows depths by the surface that is seen in each pixel. The depth test keeps what was drawn first
 * where codes are equal, so what it shows depends on the order of drawing: both ends of it are
 * shown.
 */
final class DepthKind extends RowKind<DepthFormat, DepthRows, StoredDepths> {
    private static final int[] COLORS = {
        0xFFE69F00, 0xFF56B4E9, 0xFF009E73, 0xFFCC79A7, 0xFF0072B2, 0xFFF0E442
    };

    DepthKind() {
        this(new DepthBufferTopic());
    }

    DepthKind(Topic<DepthFormat, DepthRows, StoredDepths> topic) {
        super(topic);
    }

    @Override
    int pixels(DepthRows rows) {
        return rows.pixels();
    }

    @Override
    List<RowScene.ColorBand> right(DepthRows rows, StoredDepths exact) {
        return List.of(band("right", rows, exact::front));
    }

    @Override
    List<RowScene.ColorBand> made(DepthRows rows, StoredDepths actual) {
        return List.of(
                band("inOrder", rows, actual::front),
                band("backwards", rows, pixel -> lastFront(actual, pixel)));
    }

    private static RowScene.ColorBand band(String key, DepthRows rows, IntUnaryOperator surface) {
        return new RowScene.ColorBand(
                key,
                IntStream.range(0, rows.pixels())
                        .map(pixel -> COLORS[surface.applyAsInt(pixel) % COLORS.length])
                        .toArray(),
                pixel -> String.valueOf(surface.applyAsInt(pixel) + 1));
    }

    /** The surface that is left where the last one is drawn first. */
    private static int lastFront(StoredDepths stored, int pixel) {
        int front = stored.surfaces() - 1;
        for (int s = front - 1; s >= 0; s--)
            if (code(stored, s, pixel) < code(stored, front, pixel)) front = s;
        return front;
    }

    private static int code(StoredDepths stored, int surface, int pixel) {
        return stored.codes()[surface * stored.pixels() + pixel];
    }

    private static double depth(StoredDepths stored, int surface, int pixel) {
        return stored.depths()[surface * stored.pixels() + pixel];
    }

    @Override
    double error(DepthRows rows, StoredDepths exact, StoredDepths actual, int pixel) {
        double worst = 0;
        for (int s = 0; s < rows.surfaces(); s++)
            worst = Math.max(worst, Math.abs(depth(actual, s, pixel) / depth(exact, s, pixel) - 1));
        return worst;
    }

    /** Whether two surfaces are not in their order, or one of two that are level is before. */
    @Override
    boolean wrong(DepthRows rows, StoredDepths exact, StoredDepths actual, int pixel) {
        for (int s = 0; s < rows.surfaces(); s++)
            for (int other = 0; other < s; other++) {
                int right = Integer.compare(code(exact, s, pixel), code(exact, other, pixel));
                int told = Integer.compare(code(actual, s, pixel), code(actual, other, pixel));
                if (right != told) return true;
            }
        return false;
    }

    @Override
    RowScene.PixelNumbers numbers(
            DepthRows rows, StoredDepths exact, Optional<StoredDepths> actual, int pixel) {
        var headings = new ArrayList<>(List.of("surface", "depth"));
        if (actual.isPresent()) headings.addAll(List.of("code", "storedDepth"));
        var lines = new ArrayList<RowScene.NumberRow>();
        for (int s = 0; s < rows.surfaces(); s++) {
            String name = String.valueOf(s + 1);
            double z = depth(exact, s, pixel);
            lines.add(
                    actual.isEmpty()
                            ? new RowScene.NumberRow(name, z)
                            : new RowScene.NumberRow(
                                    name,
                                    z,
                                    code(actual.get(), s, pixel),
                                    depth(actual.get(), s, pixel)));
        }
        return new RowScene.PixelNumbers(headings, lines);
    }
}
