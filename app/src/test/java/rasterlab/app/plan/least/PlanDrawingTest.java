package rasterlab.app.plan.least;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.plan.ToleratedDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

@Timeout(120)
class PlanDrawingTest {
    private static final Tolerance TOLERANCE = new Tolerance(1, 6, 0);

    /** Levels within the tolerance, of which twice as many are not. */
    private static final int TINT = 5;

    private final Renderer renderer = new Renderer();
    private final PlanDrawing drawing = new PlanDrawing();
    private final Scene torus = onGray(Scenes.named("torus", 64));
    private final Map<Look, Integer> tints = new IdentityHashMap<>();
    private RenderRequest full = seen(0);

    @AfterEach
    void close() {
        renderer.close();
    }

    /** A ground that can get both brighter and darker. */
    private static Scene onGray(Scene scene) {
        return new Scene(
                scene.name(),
                scene.mesh(),
                scene.finishes(),
                scene.finishOf(),
                scene.light(),
                0x808080,
                scene.defaultCamera(),
                scene.pictureScale(),
                scene.surfaces());
    }

    private RenderRequest seen(double turned) {
        SphericalView at = torus.defaultCamera();
        var camera = new SphericalView(at.thetaRadians() + turned, at.phiRadians(), at.rho());
        return new RenderRequest(torus, "pipeline", "phong", "perspective", camera, 96, 72);
    }

    /** Shows the picture from a camera that has turned. */
    private PlannedPicture shown(double turned) {
        PlannedPicture picture = drawing.drawn(seen(turned), TOLERANCE, this::picture, () -> false);
        full = picture.plan().full().from(picture.camera());
        drawing.shown(picture);
        return picture;
    }

    /**
     * Each plan's pictures are a little too bright or too dark, in turns; the full ones are not.
     */
    private Raster picture(RenderRequest request, BooleanSupplier cancelled) {
        Raster raster = renderer.render(request, cancelled);
        Look look = request.look();
        boolean whole =
                request.scene() == torus
                        && look.shading() == ShadingMethod.PHONG
                        && look.savings().equals(Savings.NONE);
        if (whole) return raster;
        int tint = tints.computeIfAbsent(look, unknown -> tints.size() % 2 == 0 ? TINT : -TINT);
        for (int i = 0; i < raster.argb().length; i++) raster.argb()[i] = with(raster, i, tint);
        return raster;
    }

    private static int with(Raster raster, int i, int tint) {
        int green = raster.argb()[i] >> 8 & 255;
        int other = Math.max(0, Math.min(255, green + tint));
        return raster.argb()[i] & 0xFFFF00FF | other << 8;
    }

    @Test
    @DisplayName("each picture of a drag is planned anew, or the plan outlives its range")
    void planIsKeptWhileItHolds() {
        PlannedPicture first = shown(0);
        double range = first.plan().range().turn();
        for (int k = 1; k <= 4; k++) {
            PlannedPicture next = shown(k * range / 5);
            assertSame(first.plan(), next.plan());
            assertEquals(k + 1, next.pictures());
        }
        assertNotSame(first.plan(), shown(1.5 * range).plan());
    }

    @Test
    @DisplayName("the picture jumps by more than the tolerance where the next plan begins")
    void changeOfPlansIsNoJump() {
        PlannedPicture first = shown(0);
        assertTrue(first.plan().saves());
        double turned = 1.5 * first.plan().range().turn();
        RenderRequest before = first.plan().least().from(seen(turned).camera());
        PlannedPicture between = shown(turned);
        assertTrue(apart(picture(before, () -> false), between.raster()).within(TOLERANCE));
        assertFalse(between.plan().saves(), "a full picture is what both plans are near to");
        PlannedPicture after = shown(turned + 0.001);
        assertTrue(after.plan().saves(), "the full picture stays");
        assertTrue(apart(renderer.render(full, () -> false), after.raster()).within(TOLERANCE));
    }

    private static ToleratedDifference apart(Raster one, Raster other) {
        return ToleratedDifference.of(one, other, TOLERANCE);
    }

    @Test
    @DisplayName("a plan goes on drawing after measuring found it outside its tolerance")
    void refutedPlanDrawsNoMore() {
        PlannedPicture first = shown(0);
        drawing.refute(first.plan());
        PlannedPicture next = shown(0);
        assertFalse(next.plan().saves());
        assertArrayEquals(renderer.render(full, () -> false).argb(), next.raster().argb());
    }

    @Test
    @DisplayName("another tolerance is held against the one before, as if it were the same drag")
    void anotherToleranceBeginsAnew() {
        shown(0);
        var other = new Tolerance(1, 3, 0);
        PlannedPicture next = drawing.drawn(seen(0), other, renderer::render, () -> false);
        assertEquals(other, next.plan().tolerance());
        assertEquals(1, next.pictures());
    }

    @Test
    @DisplayName("the difference is not scaled, is brighter than white, or of one channel only")
    void differenceIsAsBrightAsItCanBe() {
        var a = new Raster(2, 1);
        var b = new Raster(2, 1);
        a.argb()[0] = 0xFF102030;
        b.argb()[0] = 0xFF122031;
        a.argb()[1] = b.argb()[1] = 0xFF777777;
        var found = MagnifiedDifference.of(a, b, true);
        assertEquals(2, found.largest());
        assertEquals(64, found.factor());
        assertEquals(0xFF800040, found.raster().argb()[0]);
        assertEquals(0xFF000000, found.raster().argb()[1]);
        assertEquals(1, MagnifiedDifference.of(a, a, true).factor());
        assertEquals(1, MagnifiedDifference.of(a, b, false).factor());
    }
}
