package rasterlab.engine.scene.shape;

import rasterlab.engine.range.Finite;

/**
 * A place on a texture; beyond 0 to 1 it depends on how the texture repeats.
 *
 * @param s 0 to 1 from left to right
 * @param t 0 to 1 from bottom to top
 */
public record TexturePlace(double s, double t) {
    public TexturePlace {
        Finite.require("s", s);
        Finite.require("t", t);
    }
}
