package rasterlab.engine.pipeline.direct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.light.Material;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.FlatPaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.exact.ExactVisibility;
import rasterlab.engine.visibility.hidden.PixelAnswers;

/** The pipeline's pictures of scenes beside those of one ray for each pixel. */
class DirectPictureTest {
    /** Levels that light in floats may be off by. */
    private static final int LEVELS = 2;

    private static final double ALLOWED = 5e-4;

    private static final List<String> LIT = List.of("flat", "gouraud", "phong");
    private static final List<String> ALL = List.of("tone", "flat", "gouraud", "phong");

    private final Renderer renderer = new Renderer();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("looks")
    @Tag("slow")
    void isTheExactPicture(String scene, String shading, String projection) {
        var request = request(Scenes.named(scene), "pipeline", shading, projection);
        double share =
                wrongShare(request.withVisibility(Renderer.REFERENCE), request, answers(request));
        assertTrue(share <= ALLOWED, () -> "share of wrong pixels: " + share);
    }

    static Stream<Arguments> looks() {
        List<Arguments> looks = new ArrayList<>();
        for (Scene scene : Scenes.all().stream().filter(DirectPictureTest::hasOneAnswer).toList())
            for (String projection : List.of("perspective", "parallel", "cavalier"))
                for (String shading : seenThrough(scene) ? LIT : ALL)
                    looks.add(
                            argumentSet(
                                    "%s, %s, %s is shifted, mirrored or lit from elsewhere"
                                            .formatted(scene.name(), projection, shading),
                                    scene.name(),
                                    shading,
                                    projection));
        return looks.stream();
    }

    /** Whether the scene has one right answer: of surfaces at one place any may be seen. */
    private static boolean hasOneAnswer(Scene scene) {
        return !scene.name().equals("coplanar");
    }

    private static boolean seenThrough(Scene scene) {
        return scene.finishes().stream().anyMatch(finish -> finish.front().alpha() < 1);
    }

    @Test
    @DisplayName("glass hides what is behind it, or is mixed in the mesh's order")
    void mixesGlassFromFarToNear() {
        Scene panes = panes();
        for (String shading : List.of("flat", "phong")) {
            var request = request(panes, "pipeline", shading, "perspective");
            double share = wrongShare(request.withVisibility("painter"), request, (x, y) -> false);
            assertTrue(share <= ALLOWED, () -> shading + ": share of wrong pixels: " + share);
        }
    }

    @Test
    @DisplayName("numbers of transparent faces are mixed into rubbish")
    void refusesToNumberGlass() {
        var request = request(panes(), "pipeline", "tone", "perspective");
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> renderer.render(request, () -> false));
        assertEquals(
                "pipeline: face 0 is transparent; with shading tone or a depth cue only other methods,"
                        + " such as zfloat, mix it",
                refusal.getMessage());
    }

    @ParameterizedTest(name = "{0}: light or another texel is seen where texels hide the surface")
    @EnumSource(names = {"REPLACE", "DECAL"})
    @Tag("slow")
    void textureThatHidesTheSurfaceIsTheRaysPicture(Mode mode) {
        Scene globe = Scenes.named("globe").with(finish -> finish.with(laid(finish, mode)));
        for (String shading : LIT) {
            var request = request(globe, "pipeline", shading, "perspective");
            double share =
                    wrongShare(
                            request.withVisibility(Renderer.REFERENCE), request, answers(request));
            assertTrue(share <= ALLOWED, () -> shading + ": share of wrong pixels: " + share);
        }
    }

    @Test
    @DisplayName("faces beside texels that hide the surface are not lit")
    void facesBesideATextureThatHidesTheSurfaceAreLit() {
        Scene globe = Scenes.named("globe");
        Appearance hidden = globe.finish(0).with(laid(globe.finish(0), Mode.REPLACE));
        int[] finishOf = IntStream.range(0, globe.mesh().faceCount()).map(f -> f % 2).toArray();
        Scene scene =
                new Scene(
                        globe.name(),
                        globe.mesh(),
                        List.of(hidden, Appearance.dull(0xFF4020)),
                        finishOf,
                        globe.light(),
                        globe.backgroundRgb(),
                        globe.defaultCamera(),
                        globe.pictureScale());
        for (String shading : LIT) {
            var request = request(scene, "pipeline", shading, "perspective");
            double share =
                    wrongShare(
                            request.withVisibility(Renderer.REFERENCE), request, answers(request));
            assertTrue(share <= ALLOWED, () -> shading + ": share of wrong pixels: " + share);
        }
    }

    @ParameterizedTest(name = "{0}: glass under texels is opaque")
    @EnumSource(names = {"REPLACE", "DECAL"})
    void glassUnderATextureThatHidesItsColorStaysGlass(Mode mode) {
        Scene quad =
                Scenes.named("textured-quad")
                        .with(finish -> glass(0xFFFFFF).with(laid(finish, mode)));
        var request = request(quad, "pipeline", "gouraud", "perspective");
        double share = wrongShare(request.withVisibility("painter"), request, (x, y) -> false);
        assertTrue(share <= ALLOWED, () -> "share of wrong pixels: " + share);
    }

    private static LaidTexture laid(Appearance finish, Mode mode) {
        LaidTexture laid = finish.texture().orElseThrow();
        return new LaidTexture(
                laid.texture(),
                laid.alongS(),
                laid.alongT(),
                TextureEnvironment.of(mode, laid.texture()));
    }

    /** Two panes one behind the other, the nearer one listed first. */
    private static Scene panes() {
        double[] xyz = new double[24];
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = v < 4 ? 20 : -20;
            xyz[3 * v + 1] = v % 4 == 0 || v % 4 == 3 ? -40 : 40;
            xyz[3 * v + 2] = v % 4 < 2 ? -40 : 40;
        }
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}});
        List<Appearance> finishes = List.of(glass(0xFF4020), glass(0x2040FF));
        return new Scene(
                "panes",
                mesh,
                finishes,
                new int[] {0, 1},
                SceneLight.lampAtEye(),
                0x203040,
                new SphericalView(0.2, 1.4, 300),
                3);
    }

    private static Appearance glass(int rgb) {
        var opaque = Appearance.dull(rgb).front();
        return Appearance.of(new Material(opaque.surface(), 0.5));
    }

    private static RenderRequest request(
            Scene scene, String visibility, String shading, String projection) {
        return new RenderRequest(
                scene, visibility, shading, projection, scene.defaultCamera(), 400, 300);
    }

    /**
     * @param excused pixels at which another colour is right too
     */
    private double wrongShare(
            RenderRequest expected, RenderRequest actual, BiPredicate<Integer, Integer> excused) {
        int[] exact = renderer.render(expected, () -> false).argb();
        Raster picture = renderer.render(actual, () -> false);
        int wrong = 0;
        for (int i = 0; i < exact.length; i++)
            if (differ(exact[i], picture.argb()[i])
                    && !excused.test(i % picture.width(), i / picture.width())) wrong++;
        return (double) wrong / exact.length;
    }

    /** Pixels in which one face is seen exactly and the pipeline another that is as near there. */
    private static BiPredicate<Integer, Integer> answers(RenderRequest request) {
        Scene scene = request.scene();
        var view =
                new ViewedMesh(
                        scene.mesh(),
                        new ViewTransform(request.camera(), request.projection()),
                        PictureFit.of(request.width(), request.height(), scene.pictureScale()));
        Raster exact = numbers(new ExactVisibility(), view);
        Raster drawn = numbers(pipeline(), view);
        var answers = new PixelAnswers(view);
        return (x, y) ->
                exact.argb(x, y) != drawn.argb(x, y) && answers.right(drawn.argb(x, y) - 1, x, y);
    }

    private static Visibility pipeline() {
        return Renderer.visibilityMethods().stream()
                .filter(each -> each.name().equals(Renderer.PIPELINE))
                .findFirst()
                .orElseThrow()
                .implementation();
    }

    private static Raster numbers(Visibility method, ViewedMesh view) {
        int[] fill = IntStream.rangeClosed(1, view.mesh().faceCount()).toArray();
        var out = new Raster(view.fit().width(), view.fit().height());
        method.draw(view, new FlatPaint(fill, new int[0]), out, () -> false);
        return out;
    }

    private static boolean differ(int a, int b) {
        for (int shift = 0; shift < 24; shift += 8)
            if (Math.abs((a >> shift & 255) - (b >> shift & 255)) > LEVELS) return true;
        return false;
    }
}
