package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

/** The z-buffer against the reference; figures are printed, as the course asks for them. */
@Tag("slow")
class AgreementTest {
    private static final double ALLOWED = 0.0005;
    private static final long SEED = 20240917;

    /** Scenes on which a float tells all depths apart. */
    private static final List<String> WORKED = List.of("vase", "house");

    private final Renderer renderer = new Renderer();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("views")
    void zfloatIsWithinTheAllowedShare(String scene, SphericalView camera) {
        for (String projection : Renderer.projections())
            compare(Scenes.named(scene), "zfloat", projection, camera, 800, 600);
    }

    static Stream<Arguments> views() {
        double right = Math.PI / 2;
        List<Arguments> views = new ArrayList<>();
        for (String name : WORKED) {
            SphericalView camera = Scenes.named(name).defaultCamera();
            views.add(argumentSet(name + " default view is wrong", name, camera));
            add(views, name + ": inner side is missing from above", 0.4, 0.7, 500);
            add(views, name + ": bottom is missing from below", 0.4, 2.6, 500);
            add(views, name + ": edges on pixel centres change hands", 0, right, 500);
            add(views, name + ": edge-on faces are hit", right, right, 300);
            add(views, name + ": view from the pole fails", 0.3, 0, 400);
            add(views, name + ": view from the other pole fails", 0.3, Math.PI, 400);
            add(views, name + ": faces behind the eye are drawn", 1, 1.2, 20);
            add(views, name + ": eye close to the middle draws rubbish", 2, 1.9, 0.001);
            add(views, name + ": depth is interpolated as z", 0.2, 1, 150);
            add(views, name + ": far eye cannot tell depths", 0.2, 1, 20000);
        }
        return views.stream();
    }

    private static void add(List<Arguments> views, String mistake, double t, double p, double rho) {
        String scene = mistake.substring(0, mistake.indexOf(':'));
        views.add(argumentSet(mistake, scene, new SphericalView(t, p, rho)));
    }

    @Test
    @DisplayName("some random view is wrong")
    void zfloatIsWithinTheAllowedShareOnRandomViews() {
        var random = new Random(SEED);
        for (int k = 0; k < 40; k++) {
            Scene scene = Scenes.named(WORKED.get(k % WORKED.size()));
            var camera =
                    new SphericalView(
                            7 * random.nextDouble(),
                            7 * random.nextDouble(),
                            Math.pow(10, 1 + 2.5 * random.nextDouble()));
            String projection = Renderer.projections().get(k / 2 % 2);
            compare(scene, "zfloat", projection, camera, 400, 300);
        }
    }

    @Test
    @DisplayName("the textbook's painter is repaired")
    void textbookPainterIsWorse() {
        for (String name : WORKED)
            for (String projection : List.of("perspective", "parallel")) {
                Scene scene = Scenes.named(name);
                var camera = scene.defaultCamera();
                double share = share(scene, "painter-textbook", projection, camera, 800, 600);
                assertTrue(
                        share > 2 * ALLOWED,
                        scene.name() + " " + projection + ": only " + share + " wrong");
            }
    }

    private void compare(
            Scene scene, String method, String projection, SphericalView camera, int w, int h) {
        double share = share(scene, method, projection, camera, w, h);
        assertTrue(
                share <= ALLOWED,
                () ->
                        "%s %s, seed %d: share %s of wrong pixels at %s"
                                .formatted(scene.name(), projection, SEED, share, camera));
    }

    private double share(
            Scene scene, String method, String projection, SphericalView camera, int w, int h) {
        var request = new RenderRequest(scene, method, "tone", projection, camera, w, h);
        Raster exact = renderer.render(request.withVisibility(Renderer.REFERENCE), () -> false);
        var difference = PictureDifference.of(exact, renderer.render(request, () -> false));
        System.out.printf(
                "%s %s %s θ=%.3f φ=%.3f ρ=%.3f: %d of %d pixels wrong (%.4f %%)%n",
                scene.name(),
                method,
                projection,
                camera.thetaRadians(),
                camera.phiRadians(),
                camera.rho(),
                difference.wrongPixels(),
                difference.pixels(),
                100 * difference.share());
        return difference.share();
    }
}
