package rasterlab.engine.pipeline.surface;

import java.util.List;
import rasterlab.contract.LightSource;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** Surfaces of every kind under a lamp and a sun. */
final class LitSurfaces {
    private static final Texture CHECKS =
            Texture.of(2, 2, 4, new int[] {0xFFFF8040, 0x80204080, 0x40C0C0C0, 0xFF10F020});

    private LitSurfaces() {}

    static PointLighting lighting() {
        var model =
                LightModel.openGl(
                                Light.at(LightSource.white(), 1, 2, 0.5),
                                Light.from(LightSource.white(), -1, 0.2, 0.3))
                        .withLocalViewer()
                        .withTwoSides();
        var front = Material.dull(0.5, 0.3, 0.2).shiny(0.4, 20);
        var lighting = new PointLighting(model, front, Material.dull(0.1, 0.2, 0.6));
        lighting.eye(0, 0, 0, 0, 0, 1);
        return lighting;
    }

    static Surface.Smooth gouraud() {
        return new Surface.Smooth(new LitVertices(lighting()));
    }

    static Surface.PerPixel textured(TexelFilter filter, PixelColors under) {
        var environment = TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, CHECKS);
        var sampler = new TextureSampler(CHECKS, Wrap.REPEAT, Wrap.MIRRORED);
        return new Surface.PerPixel(new TexturedPixels(sampler, filter, environment, under));
    }

    static List<Surface> all() {
        var phong = new LitPixels(lighting());
        var flat = new Surface.Flat(gouraud().colors());
        return List.of(
                gouraud(),
                flat,
                new Surface.PerPixel(phong),
                new Surface.PerPixel(LitPixels.tinted(lighting())),
                textured(TexelFilter.NEAREST, new ColoredPixels()).over(gouraud()),
                textured(TexelFilter.LINEAR, new ColoredPixels()).over(flat),
                textured(TexelFilter.MIPMAP, phong),
                textured(TexelFilter.AFFINE_NEAREST, phong),
                textured(TexelFilter.MIPMAP, phong).with(Blending.GLASS),
                textured(TexelFilter.NEAREST, phong).with(Blending.OVER.dropBelow(100)));
    }
}
