package rasterlab.app.row;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.transform.Images;

/** Texture coordinates as what a board of 32×32 fields, each of 8×8 texels, has there. */
final class MappingKind extends RowKind<TextureMapper, TexturedSpan, Images> {
    private static final int TEXELS = 256;
    private static final int FIELD = 8;

    /** Texels beyond which the topic calls coordinates wrong. */
    private static final double USABLE = 0.5;

    private static final int[] COLORS = {0xFFFFFFFF, 0xFF0072B2, 0xFFE69F00, 0xFF1B1F24};

    private final TextureSampler board = new TextureSampler(board(), Wrap.REPEAT, Wrap.REPEAT);

    MappingKind() {
        this(new OwnMethods());
    }

    MappingKind(OwnMethods own) {
        super(own.in(new MappingTopic()));
    }

    /** Neighbours along s and along t differ, so that a step in either is seen. */
    private static Texture board() {
        int[] argb =
                IntStream.range(0, TEXELS * TEXELS)
                        .map(i -> i % TEXELS / FIELD % 2 + 2 * (i / TEXELS / FIELD % 2))
                        .map(field -> COLORS[field])
                        .toArray();
        return Texture.of(TEXELS, TEXELS, 3, argb);
    }

    @Override
    int pixels(TexturedSpan span) {
        return span.pixels();
    }

    @Override
    List<RowScene.ColorBand> right(TexturedSpan span, Images exact) {
        return List.of(band("right", exact));
    }

    @Override
    List<RowScene.ColorBand> made(TexturedSpan span, Images actual) {
        return List.of(band("method", actual));
    }

    private RowScene.ColorBand band(String key, Images st) {
        return new RowScene.ColorBand(
                key,
                IntStream.range(0, st.size())
                        .map(
                                i ->
                                        board.nearest(
                                                st.coordinates()[2 * i],
                                                st.coordinates()[2 * i + 1]))
                        .toArray());
    }

    @Override
    double error(TexturedSpan span, Images exact, Images actual, int pixel) {
        double s = actual.coordinates()[2 * pixel] - exact.coordinates()[2 * pixel];
        double t = actual.coordinates()[2 * pixel + 1] - exact.coordinates()[2 * pixel + 1];
        return TEXELS * Math.max(Math.abs(s), Math.abs(t));
    }

    @Override
    boolean wrong(TexturedSpan span, Images exact, Images actual, int pixel) {
        return error(span, exact, actual, pixel) > USABLE;
    }

    @Override
    RowScene.PixelNumbers numbers(
            TexturedSpan span, Images exact, Optional<Images> actual, int pixel) {
        return RowScene.PixelNumbers.of(
                List.of("s", "t"), place(exact, pixel), actual.map(made -> place(made, pixel)));
    }

    private static double[] place(Images images, int pixel) {
        return Arrays.copyOfRange(images.coordinates(), 2 * pixel, 2 * pixel + 2);
    }
}
