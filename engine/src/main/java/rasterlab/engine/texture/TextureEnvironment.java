package rasterlab.engine.texture;

/**
 * How a texel and the colour of the surface become one.
 *
 * <p>With f the surface, t the texel, c the environment's colour, v the result; C a colour, L a
 * luminance, A alpha:
 *
 * <pre>
 *            1 (L)                2 (L, A)             3 (C)               4 (C, A)
 * MODULATE   Lt·Cf, Af            Lt·Cf, At·Af         Ct·Cf, Af           Ct·Cf, At·Af
 * DECAL      –                    –                    Ct, Af              (1−At)·Cf+At·Ct, Af
 * BLEND      (1−Lt)·Cf+Lt·Cc, Af  (1−Lt)·Cf+Lt·Cc,     (1−Ct)·Cf+Ct·Cc, Af (1−Ct)·Cf+Ct·Cc,
 *                                 At·Af                                    At·Af
 * REPLACE    Lt, Af               Lt, At               Ct, Af              Ct, At
 * </pre>
 *
 * <p>Sources: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch.
 * 15 (MODULATE, DECAL, BLEND; BLEND for 1 and 2 components only); M. Segal, K. Akeley, The OpenGL
 * Graphics System: A Specification, version 1.1, 1997, section 3.8.5 (the rest).
 *
 * @param mode the row of the table
 * @param components the column of the table, 1 to 4: those of the texture
 * @param argb the environment's colour, for BLEND; its alpha does not count
 */
public record TextureEnvironment(Mode mode, int components, int argb) {
    /** The rows of the table. */
    public enum Mode {
        MODULATE,
        DECAL,
        BLEND,
        REPLACE
    }

    public TextureEnvironment {
        if (components < 1 || components > 4)
            throw new IllegalArgumentException("components must be from 1 to 4, got " + components);
        if (mode == Mode.DECAL && components < 3)
            throw new IllegalArgumentException(
                    "DECAL needs a texture of 3 or 4 components, got " + components);
    }

    /** The texture's own column, without an environment's colour. */
    public static TextureEnvironment of(Mode mode, Texture texture) {
        return new TextureEnvironment(mode, texture.components(), 0);
    }

    /** Whether an opaque surface stays so under every texel. */
    public boolean keepsSurfaceAlpha() {
        return components % 2 == 1 || mode == Mode.DECAL;
    }

    /** Whether nothing is seen of an opaque surface's colours. */
    public boolean hidesSurface() {
        return mode == Mode.REPLACE || mode == Mode.DECAL && components == 3;
    }

    /** Each channel rounded to the nearest level. */
    public int combine(int surface, int texel) {
        int alpha = alpha(surface >>> 24, texel >>> 24);
        return alpha << 24
                | channel(surface, texel, 16) << 16
                | channel(surface, texel, 8) << 8
                | channel(surface, texel, 0);
    }

    /**
     * Combines many pixels, in place.
     *
     * @param count how many of them
     */
    public void combine(int count, int[] surface, int[] texel) {
        if (mode == Mode.MODULATE) TexelLoops.modulate(count, surface, texel, keepsSurfaceAlpha());
        else for (int i = 0; i < count; i++) surface[i] = combine(surface[i], texel[i]);
    }

    private int alpha(int surface, int texel) {
        if (keepsSurfaceAlpha()) return surface;
        return mode == Mode.REPLACE ? texel : product(surface, texel);
    }

    private int channel(int surface, int texel, int shift) {
        int f = surface >> shift & 255;
        int t = texel >> shift & 255;
        return switch (mode) {
            case MODULATE -> product(f, t);
            case REPLACE -> t;
            case DECAL -> components == 3 ? t : mixed(f, t, texel >>> 24);
            case BLEND -> mixed(f, argb >> shift & 255, t);
        };
    }

    /**
     * a·b/255, rounded; an exact tie cannot occur, 255 being odd. 257/65536 stands for 1/255: right
     * for all a and b from 0 to 255.
     */
    static int product(int a, int b) {
        return (a * b + 128) * 257 >> 16;
    }

    /** ((255 − share)·a + share·b)/255, rounded. */
    private static int mixed(int a, int b, int share) {
        return (2 * ((255 - share) * a + share * b) + 255) / 510;
    }
}
