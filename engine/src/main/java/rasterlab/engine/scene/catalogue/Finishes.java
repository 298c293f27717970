package rasterlab.engine.scene.catalogue;

import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Finish;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;

/** What surfaces of the scenes look like. */
final class Finishes {
    private Finishes() {}

    /** A finish with small white highlights. */
    static Finish glossy(int rgb) {
        return Finish.of(dull(rgb).shiny(0.6, 60));
    }

    /** A finish with large faint highlights. */
    static Finish satin(int rgb) {
        return Finish.of(dull(rgb).shiny(0.25, 15));
    }

    /** Glossy, and lets light through. */
    static Finish glass(int rgb, double alpha) {
        return Finish.of(new Material(dull(rgb).shiny(0.8, 100).surface(), alpha));
    }

    /** A finish lit by nothing but itself. */
    static Finish glowing(int rgb) {
        double[] none = new double[3];
        double[] own = dull(rgb).surface().diffuse();
        return Finish.of(new Material(new SurfaceMaterial(none, none, none, own, 0), 1));
    }

    /** White and glossy under a picture that light falls on. */
    static Finish pictured(Texture texture) {
        return glossy(0xFFFFFF)
                .with(
                        new LaidTexture(
                                texture,
                                Wrap.REPEAT,
                                Wrap.REPEAT,
                                TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, texture)));
    }

    private static Material dull(int rgb) {
        return Finish.dull(rgb).front();
    }
}
