package rasterlab.engine.scene.catalogue;

import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;

/** The materials of the scenes' surfaces. */
final class Appearances {
    private Appearances() {}

    /** A finish with small white highlights. */
    static Appearance glossy(int rgb) {
        return Appearance.of(dull(rgb).shiny(0.6, 60));
    }

    /** A finish with large faint highlights. */
    static Appearance satin(int rgb) {
        return Appearance.of(dull(rgb).shiny(0.25, 15));
    }

    /** Glossy, and lets light through. */
    static Appearance glass(int rgb, double alpha) {
        return Appearance.of(new Material(dull(rgb).shiny(0.8, 100).surface(), alpha));
    }

    /** A finish lit by nothing but itself. */
    static Appearance glowing(int rgb) {
        double[] none = new double[3];
        double[] own = dull(rgb).surface().diffuse();
        return Appearance.of(new Material(new SurfaceMaterial(none, none, none, own, 0), 1));
    }

    /** White and glossy under a picture that light falls on. */
    static Appearance pictured(Texture texture) {
        return glossy(0xFFFFFF)
                .with(
                        new LaidTexture(
                                texture,
                                Wrap.REPEAT,
                                Wrap.REPEAT,
                                TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, texture)));
    }

    private static Material dull(int rgb) {
        return Appearance.dull(rgb).front();
    }
}
