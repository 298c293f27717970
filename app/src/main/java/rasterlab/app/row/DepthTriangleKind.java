package rasterlab.app.row;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.visibility.triangle.DepthTriangleTopic;
import rasterlab.engine.visibility.triangle.DepthTriangles;

/** Triangles in a depth buffer as what each pixel of the picture shows, row behind row. */
final class DepthTriangleKind
        extends RowKind<DepthTriangleFiller, DepthTriangles, DepthTriangles.TrianglePicture> {
    private static final int BACKGROUND = 0xFF7F7F7F;
    private static final int[] COLORS = {0xFFE69F00, 0xFF56B4E9, 0xFF009E73, 0xFFCC79A7};

    /** The share of the depth range beyond which the topic calls a depth wrong. */
    private static final double USABLE = 1.0 / (1 << 16);

    DepthTriangleKind() {
        this(new OwnMethods());
    }

    DepthTriangleKind(OwnMethods own) {
        super(own.in(new DepthTriangleTopic()));
    }

    @Override
    boolean asksSteps() {
        return true;
    }

    @Override
    int pixels(DepthTriangles input) {
        return input.width() * input.height();
    }

    @Override
    List<RowScene.ColorBand> right(DepthTriangles input, DepthTriangles.TrianglePicture exact) {
        return List.of(band("right", exact));
    }

    @Override
    List<RowScene.ColorBand> made(DepthTriangles input, DepthTriangles.TrianglePicture actual) {
        return List.of(band("method", actual));
    }

    private static RowScene.ColorBand band(String key, DepthTriangles.TrianglePicture picture) {
        return new RowScene.ColorBand(
                key,
                IntStream.of(picture.shown()).map(DepthTriangleKind::color).toArray(),
                pixel -> picture.shown()[pixel] == 0 ? "" : "" + picture.shown()[pixel]);
    }

    private static int color(int triangle) {
        return triangle == 0 ? BACKGROUND : COLORS[(triangle - 1) % COLORS.length];
    }

    @Override
    double error(
            DepthTriangles input,
            DepthTriangles.TrianglePicture exact,
            DepthTriangles.TrianglePicture actual,
            int pixel) {
        return Math.abs(exact.depths()[pixel] - actual.depths()[pixel]);
    }

    @Override
    boolean wrong(
            DepthTriangles input,
            DepthTriangles.TrianglePicture exact,
            DepthTriangles.TrianglePicture actual,
            int pixel) {
        return exact.shown()[pixel] != actual.shown()[pixel]
                || error(input, exact, actual, pixel) > USABLE;
    }

    @Override
    RowScene.PixelNumbers numbers(
            DepthTriangles input,
            DepthTriangles.TrianglePicture exact,
            Optional<DepthTriangles.TrianglePicture> actual,
            int pixel) {
        int x = pixel % input.width();
        int y = pixel / input.width();
        return RowScene.PixelNumbers.of(
                List.of("x", "y", "№", "z"),
                new double[] {x, y, exact.shown()[pixel], exact.depths()[pixel]},
                actual.map(made -> new double[] {x, y, made.shown()[pixel], made.depths()[pixel]}));
    }
}
