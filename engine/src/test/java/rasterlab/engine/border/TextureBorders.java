package rasterlab.engine.border;

import java.util.List;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.filter.FilteredPixels;
import rasterlab.engine.texture.mapping.MappingTopic;

/** Rows of a textured face, and pixels that show a picture. */
final class TextureBorders {
    private static final double FARTHEST = 1000;
    private static final double MOST_TEXELS = 12;

    private TextureBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(new MappingTopic(), TextureBorders::span),
                Border.of(
                        new FilterTopic(),
                        TextureBorders::pixels,
                        (method, pixels, message) ->
                                pixels.footprints()[3] != 0 || pixels.footprints()[4] != 0));
    }

    private static TexturedSpan span(Draws draws) {
        int pixels =
                draws.pick(50) == 49 ? draws.whole(1, TexturedSpan.MOST_PIXELS) : 1 + draws.pick(9);
        return new TexturedSpan(
                draws.number(-FARTHEST, FARTHEST),
                draws.number(-FARTHEST, FARTHEST),
                draws.number(1e-6, 1e6),
                draws.number(-FARTHEST, FARTHEST),
                draws.number(-FARTHEST, FARTHEST),
                draws.number(1e-6, 1e6),
                pixels);
    }

    private static FilteredPixels pixels(Draws draws) {
        int width = 1 + draws.pick(4);
        int height = 1 + draws.pick(4);
        var argb = new int[width * height];
        for (int i = 0; i < argb.length; i++)
            argb[i] = draws.whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        boolean turned = draws.pick(8) == 7;
        var footprint = new double[6];
        for (int i = 0; i < 6; i++) {
            double most = MOST_TEXELS / (i % 2 == 0 ? width : height);
            footprint[i] = turned || i < 3 || i == 5 ? draws.number(-most, most) : 0;
        }
        return new FilteredPixels(width, height, argb, footprint);
    }
}
