package rasterlab.engine.texture;

import rasterlab.engine.range.Bounds;

/**
 * A texel that a filter looked up.
 *
 * @param level 0 for the picture itself, each further one half as wide and high
 * @param i its column in the level, from the left
 * @param j its row in the level, from the bottom
 * @param share of the colour, 0 to 1; those of one colour add up to 1
 * @param argb 0xAARRGGBB
 */
public record TexelShare(int level, int i, int j, double share, int argb) {
    public TexelShare {
        Bounds.requireAtLeast("level", level, 0);
        Bounds.require("share", share, 0, 1);
    }
}
