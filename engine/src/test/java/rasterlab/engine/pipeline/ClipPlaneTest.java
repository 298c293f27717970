package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.SeenPoint;
import rasterlab.engine.visibility.ViewedMesh;

class ClipPlaneTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;

    /** Planes slanted to all axes, through the bodies. */
    private static final List<ClipPlane> PLANES =
            List.of(new ClipPlane(0.6, -0.3, 0.5, 11.37), new ClipPlane(-2, 0.7, 3, 97.1));

    private static final Renderer RENDERER = new Renderer();

    @AfterAll
    static void end() {
        RENDERER.close();
    }

    @ParameterizedTest(name = "{1} draws other faces of the cut {0} than the rays meet, {2}")
    @CsvSource({
        "torus, zfloat, perspective", "torus, pipeline, perspective", "torus, bsp, perspective",
        "torus, scanline, cabinet", "torus, warnock, isometric", "torus, zfloat, cabinet",
        "cube, convex, perspective", "cube, newell, dimetric", "vase, zfloat, perspective",
        "house, auto, perspective", "sphere, auto, cavalier", "sphere, pipeline, isometric"
    })
    void cutScenesLookAsRaysMeetThem(String scene, String visibility, String projection) {
        Raster exact = picture(request(scene, Renderer.REFERENCE, projection), PLANES);
        Raster drawn = picture(request(scene, visibility, projection), PLANES);
        Raster whole = picture(request(scene, visibility, projection), List.of());
        int wrong = different(exact, drawn);
        int cut = different(whole, drawn);
        assertTrue(wrong <= 4, wrong + " pixels differ from those that rays meet");
        assertTrue(cut > 200, "only " + cut + " pixels are cut off");
    }

    @ParameterizedTest(name = "a point beyond a plane is seen: {0}")
    @ValueSource(strings = {"torus", "vase", "house"})
    void nothingBeyondAPlaneIsSeen(String scene) {
        RenderRequest request = request(scene, "zfloat", "perspective");
        ViewedMesh view =
                RequestView.of(request.with(request.look().withClipPlanes(PLANES)), WIDTH).viewed();
        int seen = 0;
        for (int y = 0; y < HEIGHT; y += 3)
            for (int x = 0; x < WIDTH; x += 3) {
                Optional<SeenPoint> point = SeenPoint.at(view, x, y);
                if (point.isEmpty()) continue;
                seen++;
                double[] p = point.get().position();
                for (ClipPlane plane : PLANES)
                    assertTrue(
                            plane.a() * p[0] + plane.b() * p[1] + plane.c() * p[2] + plane.d()
                                    > -1e-3,
                            plane + " cuts off the point in pixel " + x + ", " + y);
            }
        assertTrue(seen > 40, "only " + seen + " points are seen");
    }

    @ParameterizedTest(
            name =
                    "{0}: a plane that cuts nothing changes the picture, or one that"
                            + " cuts all leaves something")
    @ValueSource(
            strings = {
                "zfloat",
                "plain",
                "pipeline",
                "painter",
                "raycast",
                "raycast-surface",
                "wire"
            })
    void planesBesideTheScene(String method) {
        boolean wire = method.equals("wire");
        RenderRequest request = request("torus", wire ? "zfloat" : method, "perspective");
        if (wire) request = request.withShading(ShadingMethod.WIRE);
        Raster whole = picture(request, List.of());
        Raster same = picture(request, List.of(new ClipPlane(0, 0, 1, 1e5)));
        assertArrayEquals(whole.argb(), same.argb());
        Raster none = picture(request, List.of(new ClipPlane(0, 0, 1, -1e5)));
        var empty = new Raster(WIDTH, HEIGHT);
        empty.clear(0xFF000000 | request.scene().backgroundRgb());
        assertArrayEquals(empty.argb(), none.argb());
    }

    @Test
    @DisplayName("a plane cuts surfaces elsewhere than the faces that stand for them")
    void surfacesAreCutWhereFacesAre() {
        RenderRequest fine =
                request("sphere", "zfloat", "perspective").with(Scenes.named("sphere", 200));
        Raster faces = picture(fine, PLANES);
        Raster surface = picture(fine.withVisibility(Renderer.SURFACES), PLANES);
        int background = 0xFF000000 | fine.scene().backgroundRgb();
        int other = 0;
        for (int i = 0; i < faces.argb().length; i++)
            if (faces.argb()[i] == background != (surface.argb()[i] == background)) other++;
        assertTrue(other < 40, other + " pixels are background in one of the pictures only");
    }

    @Test
    @DisplayName("wires go on beyond a plane")
    void wiresAreCut() {
        UnaryOperator<Look> wires =
                look ->
                        look.withShading(ShadingMethod.WIRE)
                                .withWire(new WireStyle(HiddenLines.SHOWN, 0));
        RenderRequest front = request("cube", "zfloat", "front");
        front = front.with(wires.apply(front.look()));
        Raster whole = picture(front, List.of());
        Raster upper = picture(front, List.of(new ClipPlane(0, 0, 1, 0)));
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                if (y < HEIGHT / 2 - 1)
                    assertEquals(whole.argb(x, y), upper.argb(x, y), "pixel " + x + ", " + y);
                else if (y > HEIGHT / 2 + 1)
                    assertEquals(
                            0xFF000000 | front.scene().backgroundRgb(),
                            upper.argb(x, y),
                            "pixel " + x + ", " + y);
    }

    @Test
    @DisplayName("a plane without a direction, an endless number or a seventh plane is taken")
    void refusesPlanesThatCannotCut() {
        assertThrows(IllegalArgumentException.class, () -> new ClipPlane(0, 0, 0, 1));
        assertThrows(IllegalArgumentException.class, () -> new ClipPlane(1, Double.NaN, 0, 1));
        assertThrows(IllegalArgumentException.class, () -> new ClipPlane(1, 0, 0, 1e31));
        Look look = Look.of("zfloat", ShadingMethod.FLAT);
        List<ClipPlane> seven = Collections.nCopies(7, new ClipPlane(1, 0, 0, 0));
        var refusal =
                assertThrows(IllegalArgumentException.class, () -> look.withClipPlanes(seven));
        assertEquals("at most 6 clip planes can cut, got 7", refusal.getMessage());
    }

    private static RenderRequest request(String scene, String visibility, String projection) {
        var one = Scenes.named(scene);
        return new RenderRequest(
                one,
                one.defaultCamera(),
                Projection.named(projection),
                DrawnDepths.all(Projection.named(projection), one.defaultCamera().rho()),
                WIDTH,
                HEIGHT,
                Look.of(visibility, ShadingMethod.PHONG));
    }

    private static Raster picture(RenderRequest request, List<ClipPlane> planes) {
        return RENDERER.render(request.with(request.look().withClipPlanes(planes)), () -> false);
    }

    private static int different(Raster one, Raster other) {
        int count = 0;
        for (int i = 0; i < one.argb().length; i++)
            if (maxLevel(one.argb()[i], other.argb()[i]) > 2) count++;
        return count;
    }

    private static int maxLevel(int one, int other) {
        int most = 0;
        for (int shift = 0; shift <= 16; shift += 8)
            most = Math.max(most, Math.abs((one >> shift & 255) - (other >> shift & 255)));
        return most;
    }
}
