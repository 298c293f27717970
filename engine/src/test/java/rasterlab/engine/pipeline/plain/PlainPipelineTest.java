package rasterlab.engine.pipeline.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.FlatPaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.exact.ExactVisibility;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.PixelAnswers;
import rasterlab.engine.visibility.hidden.SurfaceView;

/** The page of the course beside the exact picture and beside the fast pipeline. */
class PlainPipelineTest {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;

    /** Share of pixels beside edges, which the fast pipeline rounds to 1/256 pixel. */
    private static final double ROUNDED = 1e-3;

    /** The most that this rounding, and light in floats, may change a colour. */
    private static final int LEVELS = 2;

    /** Faces in one plane, whose order rounding decides. */
    private static final List<String> COPLANAR =
            List.of("coplanar", "coplanar-turned", "coplanar-far-corners");

    private final Renderer renderer = new Renderer();

    @AfterEach
    void endThreads() {
        renderer.close();
    }

    static Stream<Arguments> views() {
        var views = new ArrayList<Arguments>();
        for (Scene scene : Scenes.all())
            for (String projection : List.of("perspective", "parallel", "cavalier"))
                views.add(argumentSet(scene.name() + ", " + projection, scene, projection));
        return views.stream();
    }

    @ParameterizedTest(name = "another face than the nearest is seen: {argumentSetName}")
    @MethodSource("views")
    @Tag("slow")
    void showsTheNearestFaceAtEveryPixel(Scene scene, String projection) {
        assertEquals("none", wrongPixels(scene, scene.defaultCamera(), projection));
    }

    @ParameterizedTest(name = "light, texture or glass is not the fast one's: {argumentSetName}")
    @MethodSource("views")
    @Tag("slow")
    void drawsThePictureOfTheFastPipeline(Scene scene, String projection) {
        if (scene.name().equals("coplanar")) return;
        var view = view(scene, scene.defaultCamera(), projection);
        Raster read = numbers(PlainPipeline::draw, view);
        Raster drawn = numbers(fast(), view);
        var answers = new PixelAnswers(view);
        IntPredicate comparable =
                i ->
                        read.argb()[i] == drawn.argb()[i]
                                || !answers.right(drawn.argb()[i] - 1, i % WIDTH, i / WIDTH);
        for (String shading : List.of("flat", "phong")) {
            int[] plain = picture(scene, projection, shading, Renderer.PLAIN);
            int[] fast = picture(scene, projection, shading, Renderer.PIPELINE);
            int[] off =
                    IntStream.range(0, plain.length)
                            .filter(i -> differ(plain[i], fast[i]) && comparable.test(i))
                            .toArray();
            assertTrue(
                    off.length <= ROUNDED * plain.length,
                    () -> shading + " differs: " + summary(off, plain, fast));
        }
    }

    private int[] picture(Scene scene, String projection, String shading, String method) {
        SphericalView camera = scene.defaultCamera();
        var request = new RenderRequest(scene, method, shading, projection, camera, WIDTH, HEIGHT);
        return renderer.render(request, () -> false).argb();
    }

    private static Visibility fast() {
        return Renderer.visibilityMethods().stream()
                .filter(method -> method.name().equals(Renderer.PIPELINE))
                .findFirst()
                .orElseThrow()
                .implementation();
    }

    @Test
    @DisplayName("what is behind the eye, or nearer than the near plane, is drawn")
    void cutsBeforeItDivides() {
        for (double rho : new double[] {0.001, 5, 20, 60}) {
            var inside = new SphericalView(1, 1.2, rho);
            assertEquals(
                    "none", wrongPixels(Scenes.named("vase"), inside, "perspective"), "ρ " + rho);
            assertEquals(
                    "none", wrongPixels(Scenes.named("house"), inside, "perspective"), "ρ " + rho);
        }
    }

    @Test
    @DisplayName("glass hides glass behind it that is listed later or crosses it")
    void whatIsSeenThroughHidesNothing() {
        Scene crossing = Scenes.named("interpenetrating");
        var glass =
                new FacePaint() {
                    @Override
                    public void span(int face, int y, int from, int to, Raster out) {}

                    @Override
                    public boolean opaque(int face) {
                        return false;
                    }
                };
        VisibilityWork work =
                PlainPipeline.draw(
                        view(crossing, crossing.defaultCamera(), "perspective"),
                        glass,
                        new Raster(WIDTH, HEIGHT),
                        () -> false);
        assertTrue(work.depthTests() > 0, "nothing is drawn");
        assertEquals(work.depthTests(), work.pixelsWritten());
    }

    @Test
    @DisplayName("a hazard other than faces in one plane is answered wrongly")
    void failsOnFacesInOnePlaneOnly() {
        var topic = new HiddenSurfacesTopic();
        Visibility plain = PlainPipeline::draw;
        var wrong = new ArrayList<String>();
        for (Hazard<SurfaceView> each : topic.hazards()) {
            SurfaceView input = each.input();
            var exact = topic.exact(input, Integer.MAX_VALUE);
            var drawn = topic.run(plain, input, Integer.MAX_VALUE);
            if (!topic.correct(topic.compare(input, exact, drawn))) wrong.add(each.name());
        }
        wrong.removeAll(COPLANAR);
        assertEquals(List.of(), wrong);
    }

    /** The wrong pixels' number and the first of them, with the number of the face in each. */
    private static String wrongPixels(Scene scene, SphericalView camera, String projection) {
        ViewedMesh view = view(scene, camera, projection);
        int[] exact = numbers(new ExactVisibility(), view).argb();
        int[] drawn = numbers(PlainPipeline::draw, view).argb();
        var answers = new PixelAnswers(view);
        int[] wrong =
                IntStream.range(0, WIDTH * HEIGHT)
                        .filter(i -> exact[i] != drawn[i])
                        .filter(i -> !answers.right(drawn[i] - 1, i % WIDTH, i / WIDTH))
                        .toArray();
        return wrong.length == 0 ? "none" : summary(wrong, drawn, exact);
    }

    private static String summary(int[] cells, int[] drawn, int[] expected) {
        int first = cells[0];
        return "%d pixels, the first (%d, %d): expected %08x, drawn %08x"
                .formatted(
                        cells.length, first % WIDTH, first / WIDTH, expected[first], drawn[first]);
    }

    private static ViewedMesh view(Scene scene, SphericalView camera, String projection) {
        return new ViewedMesh(
                scene.mesh(),
                new ViewTransform(camera, Projection.named(projection)),
                PictureFit.of(WIDTH, HEIGHT, scene.pictureScale()));
    }

    private static Raster numbers(Visibility method, ViewedMesh view) {
        int[] fill = IntStream.rangeClosed(1, view.mesh().faceCount()).toArray();
        var out = new Raster(WIDTH, HEIGHT);
        method.draw(view, new FlatPaint(fill, new int[0]), out, () -> false);
        return out;
    }

    private static boolean differ(int a, int b) {
        for (int shift = 0; shift < 24; shift += 8)
            if (Math.abs((a >> shift & 255) - (b >> shift & 255)) > LEVELS) return true;
        return false;
    }
}
