package rasterlab.engine.border;

import java.util.List;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.texture.mapping.MappingTopic;

/** Rows of a textured face. */
final class TextureBorders {
    private static final double FARTHEST = 1000;

    private TextureBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(Border.of(new MappingTopic(), TextureBorders::span));
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
}
