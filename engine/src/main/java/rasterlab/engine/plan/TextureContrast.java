package rasterlab.engine.plan;

import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureLevel;

/** The largest difference between two texels of a texture, in levels of a channel. */
final class TextureContrast {
    private TextureContrast() {}

    /**
     * @param limit above which the exact difference does not matter: the search ends there
     */
    static int of(Texture texture, double limit) {
        TextureLevel finest = texture.level(0);
        int contrast = 0;
        int first = finest.texel(0, 0);
        int[] least = new int[4];
        int[] most = new int[4];
        for (int c = 0; c < 4; c++) least[c] = most[c] = first >>> 8 * c & 255;
        for (int y = 0; y < finest.height() && contrast <= limit; y++)
            for (int x = 0; x < finest.width(); x++)
                for (int c = 0; c < 4; c++) {
                    int level = finest.texel(x, y) >>> 8 * c & 255;
                    least[c] = Math.min(least[c], level);
                    most[c] = Math.max(most[c], level);
                    contrast = Math.max(contrast, most[c] - least[c]);
                }
        return contrast;
    }
}
