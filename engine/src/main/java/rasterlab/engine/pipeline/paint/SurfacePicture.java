package rasterlab.engine.pipeline.paint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.ExactSurfaces;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.ray.RaySpan;

/**
 * A scene by its surfaces instead of its faces: one ray for each pixel, the whole formula of light
 * where it meets a surface, with that place's own normal and texture coordinates. What a mesh makes
 * of the surface shows as the difference to this.
 *
 * <p>A ray goes on through what is transparent, {@value #MOST_LAYERS} places at most. Textures are
 * looked up with the nearest or the linear filter.
 */
public final class SurfacePicture {
    private static final int MOST_LAYERS = 64;

    /** The step that a ray leaves behind when it goes on, as a share of the camera's distance. */
    private static final double STEP = 1e-9;

    private final FaceLights lights;
    private final ExactSurfaces surfaces;
    private final TextureMode filter;
    private final ViewedMesh view;

    /**
     * @param lights of a scene that has exact surfaces
     * @throws IllegalArgumentException if it has none
     */
    public SurfacePicture(FaceLights lights, TextureMode filter) {
        this.lights = lights;
        this.filter = filter;
        view = lights.view();
        surfaces =
                lights.scene()
                        .surfaces()
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "scene '%s' is made of faces, not of surfaces"
                                                        .formatted(lights.scene().name())));
    }

    /**
     * Draws over the picture's background.
     *
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public void draw(Raster out, BooleanSupplier cancelled) {
        IntStream.range(0, out.height())
                .parallel()
                .forEach(
                        row -> {
                            if (cancelled.getAsBoolean())
                                throw new CancellationException("the picture is cancelled");
                            new Row(out, row).draw();
                        });
    }

    private final class Row {
        private final Raster out;
        private final int y;
        private final ExactSurfaces.Caster caster = surfaces.caster();
        private final PointLighting[] lighting = lights.forThread();
        private final double[] ray = new double[6];
        private final RaySpan drawn = new RaySpan(view);
        private final List<TextureSampler> samplers = samplers();
        private final int[] layers = new int[MOST_LAYERS];

        Row(Raster out, int y) {
            this.out = out;
            this.y = y;
        }

        void draw() {
            for (int x = 0; x < out.width(); x++) {
                aim(x);
                int seen = layers();
                int argb = out.argb(x, y);
                while (seen > 0) argb = over(layers[--seen], argb);
                out.argb()[y * out.width() + x] = argb;
            }
        }

        /**
         * Aims at a pixel, with a direction whose length is 1 in view depth, as the view transform
         * has it.
         */
        private void aim(int x) {
            ViewTransform transform = view.transform();
            double u = view.fit().toPlaneX(x);
            double v = view.fit().toPlaneY(y);
            double share = transform.central() ? 1 / transform.distance() : 0;
            double startU = transform.central() ? 0 : u;
            double startV = transform.central() ? 0 : v;
            for (int i = 0; i < 3; i++) {
                ray[i] = transform.toWorld(i, startU, startV, 0);
                ray[3 + i] =
                        transform.toWorld(i, startU + u * share, startV + v * share, 1) - ray[i];
            }
        }

        /** Writes the colours met, the nearest first, down to the first opaque one. */
        private int layers() {
            int count = 0;
            drawn.load(ray);
            double least = Math.max(drawn.begin(), -Double.MAX_VALUE);
            while (count < MOST_LAYERS) {
                int finish = caster.meet(ray, least);
                if (finish < 0 || caster.distance() > drawn.end()) break;
                layers[count] = argb(finish);
                if (layers[count++] >>> 24 == 255) break;
                least = caster.distance() + STEP * view.transform().distance();
            }
            return count;
        }

        private int argb(int finish) {
            int light =
                    lighting[finish].argb(
                            caster.place(0),
                            caster.place(1),
                            caster.place(2),
                            caster.normal(0),
                            caster.normal(1),
                            caster.normal(2),
                            caster.fromInside());
            Optional<LaidTexture> laid = lights.scene().finishes().get(finish).texture();
            if (laid.isEmpty() || filter == TextureMode.NONE) return light;
            LaidTexture texture = laid.get();
            TextureSampler sampler = samplers.get(finish);
            int texel =
                    filter == TextureMode.NEAREST
                            ? sampler.nearest(caster.textureS(), caster.textureT())
                            : sampler.linear(caster.textureS(), caster.textureT());
            return texture.environment().combine(light, texel);
        }
    }

    /** One for each finish, null where it has no texture. */
    private List<TextureSampler> samplers() {
        List<TextureSampler> samplers = new ArrayList<>();
        for (Appearance finish : lights.scene().finishes())
            samplers.add(
                    finish.texture()
                            .map(
                                    laid ->
                                            new TextureSampler(
                                                    laid.texture(), laid.alongS(), laid.alongT()))
                            .orElse(null));
        return samplers;
    }

    /** Each channel (alpha·near + (255 − alpha)·far)/255, rounded. */
    private static int over(int near, int far) {
        int alpha = near >>> 24;
        int mixed = 0xFF000000;
        for (int shift = 0; shift <= 16; shift += 8) {
            int sum = alpha * (near >> shift & 255) + (255 - alpha) * (far >> shift & 255);
            mixed |= (2 * sum + 255) / 510 << shift;
        }
        return mixed;
    }
}
