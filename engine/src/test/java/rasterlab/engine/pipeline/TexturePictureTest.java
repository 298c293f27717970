package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;

/** Textured pictures against the texture at what each pixel's ray meets. */
class TexturePictureTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;
    private static final double[] UNEVEN = {0.3, -0.2, 1.2, 0.1, 0.9, 2.3, -0.4, 1.7};
    private static final double[] EVEN = {0, 0, 1, 0, 1, 1, 0, 1};

    private final Renderer renderer = new Renderer();

    private static Scene floor(Texture texture, Wrap wrap, double... st) {
        return LitScenes.scene(
                LitScenes.floor(st),
                LitScenes.white().with(LitScenes.laid(texture, wrap)),
                LitScenes.everywhere());
    }

    private Raster picture(Scene scene, TextureMode filter, SphericalView camera) {
        var request =
                new RenderRequest(scene, "zfloat", "flat", "perspective", camera, WIDTH, HEIGHT);
        return renderer.render(request.with(request.look().withTexture(filter)), () -> false);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void nearestIsTheTexelUnderTheRay(
            int width, int height, Wrap wrap, double[] st, SphericalView camera) {
        Texture texture = LitScenes.texels(width, height);
        Scene scene = floor(texture, wrap, st);
        Raster picture = picture(scene, TextureMode.NEAREST, camera);
        var rays = new PlainRays(scene, camera, true, WIDTH, HEIGHT);
        int wrong = 0;
        int all = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                PlainRays.Hit hit = rays.hit(x, y);
                if (hit == null || !rays.inside(x, y, hit)) continue;
                all++;
                int column = texel(s(scene, rays, hit), width, wrap);
                int row = texel(t(scene, rays, hit), height, wrap);
                if (LitScenes.texel(row * width + column) != picture.argb(x, y)) wrong++;
            }
        assertTrue(all > 3000, "only " + all + " pixels");
        assertTrue(wrong <= 2, wrong + " of " + all + " pixels are wrong");
    }

    /** The texel whose cell a coordinate is in. */
    private static int texel(double coordinate, int side, Wrap wrap) {
        int cell = (int) Math.floor(coordinate * side);
        return switch (wrap) {
            case REPEAT -> Math.floorMod(cell, side);
            case MIRRORED -> {
                int place = Math.floorMod(cell, 2 * side);
                yield Math.min(place, 2 * side - 1 - place);
            }
            default -> Math.max(0, Math.min(side - 1, cell));
        };
    }

    static Stream<Arguments> mistakes() {
        var aside = new SphericalView(0.2, 1.3, 5);
        var onTheFloor = new SphericalView(0.1, 1.35, 1.5);
        Wrap repeat = Wrap.REPEAT;
        return Stream.of(
                argumentSet("texture is affine", 16, 16, repeat, EVEN, aside),
                argumentSet(
                        "second triangle takes the first's corners", 8, 8, repeat, UNEVEN, aside),
                argumentSet("face behind the eye is not cut", 16, 16, repeat, EVEN, onTheFloor),
                argumentSet("size must be a power of two", 3, 5, repeat, UNEVEN, aside),
                argumentSet("one texel fails", 1, 1, repeat, UNEVEN, aside),
                argumentSet("rim is repeated", 8, 8, Wrap.CLAMP_TO_EDGE, UNEVEN, aside),
                argumentSet("mirror is repeated", 8, 8, Wrap.MIRRORED, UNEVEN, aside));
    }

    private static double s(Scene scene, PlainRays rays, PlainRays.Hit hit) {
        return rays.mixed(hit, k -> scene.mesh().textureS(hit.face(), k));
    }

    private static double t(Scene scene, PlainRays rays, PlainRays.Hit hit) {
        return rays.mixed(hit, k -> scene.mesh().textureT(hit.face(), k));
    }

    @Test
    @DisplayName("mip level is not that of the screen derivatives")
    void mipmapIsTheLevelOfTheStepsToTheNextPixels() {
        var camera = new SphericalView(0.2, 1.3, 5);
        Texture texture = LitScenes.texels(64, 32);
        Scene scene = floor(texture, Wrap.REPEAT, 0, 0, 3, 0, 3, 5, 0, 5);
        Raster picture = picture(scene, TextureMode.MIPMAP, camera);
        var sampler = new TextureSampler(texture, Wrap.REPEAT, Wrap.REPEAT);
        var rays = new PlainRays(scene, camera, true, WIDTH, HEIGHT);
        double h = 1e-4;
        int blurred = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                PlainRays.Hit hit = rays.hit(x, y);
                if (hit == null || !rays.inside(x, y, hit)) continue;
                double s = s(scene, rays, hit);
                double t = t(scene, rays, hit);
                PlainRays.Hit right = rays.hit(x + h, y);
                PlainRays.Hit below = rays.hit(x, y + h);
                double across =
                        Math.hypot(
                                64 * (s(scene, rays, right) - s) / h,
                                32 * (t(scene, rays, right) - t) / h);
                double down =
                        Math.hypot(
                                64 * (s(scene, rays, below) - s) / h,
                                32 * (t(scene, rays, below) - t) / h);
                double lambda = Math.log(Math.max(across, down)) / Math.log(2);
                if (lambda > 0.5) blurred++;
                int expected = sampler.trilinear(s, t, lambda);
                for (int shift = 0; shift < 24; shift += 8)
                    assertEquals(
                            expected >> shift & 255,
                            picture.argb(x, y) >> shift & 255,
                            4,
                            "pixel (%d, %d), level %s".formatted(x, y, lambda));
            }
        assertTrue(blurred > 1000, "only " + blurred + " pixels are minified");
    }

    @Test
    @DisplayName("auto blurs less or more than mipmaps, or lacks them where they are needed")
    void autoIsTheSamePictureAsMipmap() {
        for (double rho : new double[] {1.2, 5, 40}) {
            var camera = new SphericalView(0.2, 1.3, rho);
            Scene scene = floor(LitScenes.texels(64, 32), Wrap.REPEAT, UNEVEN);
            assertArrayEquals(
                    picture(scene, TextureMode.MIPMAP, camera).argb(),
                    picture(scene, TextureMode.AUTO, camera).argb());
        }
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("choices")
    void autoSaysWhatItChose(Scene scene, SphericalView camera, Choice choice) {
        var request =
                new RenderRequest(scene, "zfloat", "flat", "perspective", camera, WIDTH, HEIGHT);
        assertEquals(choice, Renderer.texture(request));
    }

    static Stream<Arguments> choices() {
        var steep = new SphericalView(0.2, 0.6, 5);
        return Stream.of(
                argumentSet(
                        "mipmaps are chosen without need",
                        floor(LitScenes.texels(2, 2), Wrap.REPEAT, EVEN),
                        steep,
                        new Choice("linear", "no pixel steps over more than a texel")),
                argumentSet(
                        "mipmaps are not chosen",
                        floor(LitScenes.texels(512, 512), Wrap.REPEAT, EVEN),
                        steep,
                        new Choice(
                                "mipmap",
                                "pixels may step over texels on 1 of 1 textured faces;"
                                        + " linear on the others")),
                argumentSet(
                        "texture is seen where there is none",
                        LitScenes.scene(
                                LitScenes.floor(EVEN), LitScenes.white(), LitScenes.everywhere()),
                        steep,
                        new Choice("none", "the scene has no texture")));
    }

    @Test
    @DisplayName("affine mapping has perspective, or is another picture in parallel projection")
    void affineDiffersInPerspectiveOnly() {
        Scene scene = floor(LitScenes.texels(16, 16), Wrap.REPEAT, EVEN);
        var camera = new SphericalView(0.2, 1.3, 5);
        int different = 0;
        int[] right = picture(scene, TextureMode.NEAREST, camera).argb();
        int[] affine = picture(scene, TextureMode.AFFINE_NEAREST, camera).argb();
        for (int i = 0; i < right.length; i++) if (right[i] != affine[i]) different++;
        assertTrue(different > 1000, different + " pixels differ");
        var parallel =
                new RenderRequest(scene, "zfloat", "flat", "parallel", camera, WIDTH, HEIGHT);
        var look = parallel.look();
        assertArrayEquals(
                renderer.render(parallel.with(look.withTexture(TextureMode.NEAREST)), () -> false)
                        .argb(),
                renderer.render(
                                parallel.with(look.withTexture(TextureMode.AFFINE_NEAREST)),
                                () -> false)
                        .argb());
    }

    @Test
    @DisplayName("affine mapping is not straight on the screen between the corners of a triangle")
    void affineMixesCornersOnTheScreen() {
        Scene scene = floor(LitScenes.texels(16, 16), Wrap.REPEAT, UNEVEN);
        var camera = new SphericalView(0.2, 1.2, 5);
        Mesh mesh = scene.mesh();
        Raster picture = picture(scene, TextureMode.AFFINE_NEAREST, camera);
        var sampler = new TextureSampler(LitScenes.texels(16, 16), Wrap.REPEAT, Wrap.REPEAT);
        int all = 0;
        int wrong = 0;
        for (int fan = 1; fan < 3; fan++) {
            double[] a = pixel(camera, scene, mesh.x(0), mesh.y(0), mesh.z(0));
            double[] b = pixel(camera, scene, mesh.x(fan), mesh.y(fan), mesh.z(fan));
            double[] c = pixel(camera, scene, mesh.x(fan + 1), mesh.y(fan + 1), mesh.z(fan + 1));
            double area = turn(a, b, c);
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++) {
                    double[] p = {x, y};
                    double w0 = turn(p, b, c) / area;
                    double w1 = turn(a, p, c) / area;
                    double w2 = 1 - w0 - w1;
                    if (w0 < 1e-3 || w1 < 1e-3 || w2 < 1e-3) continue;
                    double s = w0 * UNEVEN[0] + w1 * UNEVEN[2 * fan] + w2 * UNEVEN[2 * fan + 2];
                    double t = w0 * UNEVEN[1] + w1 * UNEVEN[2 * fan + 1] + w2 * UNEVEN[2 * fan + 3];
                    all++;
                    if (sampler.nearest(s, t) != picture.argb(x, y)) wrong++;
                }
        }
        assertTrue(all > 3000, "only " + all + " pixels");
        assertTrue(wrong <= 2, wrong + " of " + all + " pixels are wrong");
    }

    /** Twice the area of a triangle on the screen, with its sign. */
    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    private static double[] pixel(SphericalView camera, Scene scene, double x, double y, double z) {
        double[] view = new double[3];
        var matrix = camera.matrix().transformPosition(new Vector3d(x, y, z));
        view[0] = matrix.x;
        view[1] = matrix.y;
        view[2] = matrix.z;
        double scale = scene.pictureScale() * WIDTH / 800.0 * camera.rho() / view[2];
        return new double[] {WIDTH / 2 + scale * view[0], HEIGHT / 2 - scale * view[1]};
    }

    @ParameterizedTest(name = "none shows the texture: {0}")
    @ValueSource(strings = {"flat", "phong"})
    void noneShowsTheSurface(String shading) {
        Scene scene = floor(Texture.of(1, 1, 3, new int[] {0xFF123456}), Wrap.REPEAT, EVEN);
        var camera = new SphericalView(0.2, 1.2, 5);
        var request =
                new RenderRequest(scene, "zfloat", shading, "perspective", camera, WIDTH, HEIGHT);
        var bare = request.with(request.look().withTexture(TextureMode.NONE));
        int middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
        assertEquals(0xFFFFFFFF, renderer.render(bare, () -> false).argb()[middle]);
        assertEquals(0xFF123456, renderer.render(request, () -> false).argb()[middle]);
    }
}
