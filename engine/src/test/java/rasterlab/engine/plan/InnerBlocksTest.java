package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.plan.BlockBounds.BlockBound;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.shape.Torus;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;

class InnerBlocksTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;

    private final Planner planner = new Planner(2, Costs.measured());

    @ParameterizedTest(name = "{0} in {1} steps, coarser inside, leaves {2} px and {3} levels")
    @CsvSource({
        "sphere, 200, 1, 4",
        "sphere, 320, 1, 2",
        "torus, 320, 2, 24",
        "revolution, 200, 2, 16"
    })
    void picturesStayWithinTheTolerance(String name, int detail, double pixels, int levels) {
        Scene scene = Scenes.named(name, detail);
        var tolerance = new Tolerance(pixels, levels, 0);
        var random = new Random(detail);
        try (var renderer = new Renderer()) {
            for (int plans = 0; plans < 3; plans++) {
                SphericalView at = anywhere(scene.defaultCamera(), random);
                Scene coarser = coarser(scene, at, tolerance);
                for (int k = 0; k < 4; k++) {
                    SphericalView camera = near(at, random);
                    RenderRequest full = planner.full(seen(scene, camera));
                    ToleratedDifference error =
                            ToleratedDifference.of(
                                    renderer.render(full, () -> false),
                                    renderer.render(full.with(coarser), () -> false),
                                    tolerance);
                    assertTrue(error.within(tolerance), camera + ": " + error);
                }
            }
        }
    }

    @Test
    void outlineIsFinerThanTheInside() {
        Scene scene = Scenes.named("sphere", 200);
        RenderRequest asked = seen(scene, scene.defaultCamera());
        Scene coarser = coarser(scene, asked.camera(), new Tolerance(1, 4, 0));
        int faces = coarser.mesh().faceCount();
        assertTrue(faces < 0.6 * scene.mesh().faceCount(), faces + " faces");
        assertEquals(atOutline(asked), atOutline(asked.with(coarser)));
    }

    /** Plans beside a picture that takes so long that making a mesh costs nothing. */
    private static Scene coarser(Scene scene, SphericalView at, Tolerance tolerance) {
        RenderRequest request = seen(scene, at);
        var view = RequestView.of(request, request.width()).viewed();
        var known = new KnownScene(scene, new SightFacts(scene));
        ShapePlan.PlannedShapes planned =
                new ShapePlan(known, view.transform(), view.fit(), tolerance, 1e9)
                        .plan()
                        .orElseThrow();
        assertEquals("inside", planned.decisions().get(0).reason().key());
        assertEquals(CameraRange.OUTLINE, planned.turn());
        return planned.scene();
    }

    /** Faces that are looked at along their plane, within 3 degrees. */
    private static int atOutline(RenderRequest request) {
        var seen = RequestView.of(request, request.width()).viewed();
        Mesh mesh = seen.mesh();
        EyeRange eye = EyeRange.of(seen.transform(), 0);
        int faces = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            double dot = 0;
            double square = 0;
            double[] normal = {mesh.normalX(f), mesh.normalY(f), mesh.normalZ(f)};
            int corner = mesh.corner(f, 0);
            double[] at = {mesh.x(corner), mesh.y(corner), mesh.z(corner)};
            for (int axis = 0; axis < 3; axis++) {
                double way = eye.towards()[axis] - at[axis];
                dot += normal[axis] * way;
                square += way * way;
            }
            if (Math.abs(dot) < Math.sin(Math.toRadians(3)) * Math.sqrt(square)) faces++;
        }
        return faces;
    }

    @Test
    void leastCosineHoldsForAllEyesOfARange() {
        Scene scene = Scenes.named("torus", 60);
        var random = new Random(8);
        SphericalView at = scene.defaultCamera();
        EyeRange range = EyeRange.of(transform(scene, at), CameraRange.OUTLINE);
        var torus = new Torus(85, 35);
        var blocks = BlockBounds.of(torus, 60, 30, 3).blocks().get(0);
        for (int k = 0; k < 200; k++) {
            SphericalView camera = near(at, random);
            double[] eye = EyeRange.of(transform(scene, camera), 0).towards();
            for (BlockBound block : blocks) {
                double cosine = cosine(block, eye);
                assertTrue(
                        range.leastCosine(block) <= Math.abs(cosine) + 1e-12,
                        () -> camera + " sees " + block + " at " + cosine);
            }
        }
    }

    private static double cosine(BlockBound block, double[] eye) {
        double dot = 0;
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double way = eye[axis] - block.middle()[axis];
            dot += block.normal()[axis] * way;
            square += way * way;
        }
        return dot / Math.sqrt(square);
    }

    private static ViewTransform transform(Scene scene, SphericalView at) {
        RenderRequest request = seen(scene, at);
        return RequestView.of(request, request.width()).viewed().transform();
    }

    private static SphericalView anywhere(SphericalView usual, Random random) {
        return new SphericalView(
                6 * random.nextDouble(), 0.3 + 2.5 * random.nextDouble(), usual.rho());
    }

    /** A camera in the range of a plan with an outline. */
    private static SphericalView near(SphericalView at, Random random) {
        CameraRange range = CameraRange.turned(at, CameraRange.OUTLINE);
        while (true) {
            double turn = 2 * range.turn();
            var camera =
                    new SphericalView(
                            at.thetaRadians() + turn * (random.nextDouble() - 0.5),
                            at.phiRadians() + turn * (random.nextDouble() - 0.5),
                            at.rho() * (0.96 + 0.08 * random.nextDouble()));
            if (range.within(camera)) return camera;
        }
    }

    private static RenderRequest seen(Scene scene, SphericalView camera) {
        return new RenderRequest(scene, "pipeline", "phong", "perspective", camera, WIDTH, HEIGHT);
    }
}
