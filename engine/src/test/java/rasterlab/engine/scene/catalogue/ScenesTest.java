package rasterlab.engine.scene.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.joml.Vector3d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;

class ScenesTest {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;

    @Test
    @DisplayName("a scene goes by another's name")
    void namesAreThoseOfTheScenes() {
        assertEquals(Scenes.names(), Scenes.all().stream().map(Scene::name).toList());
        assertEquals(Scenes.names().size(), Set.copyOf(Scenes.names()).size());
        for (String name : Scenes.names()) assertSame(Scenes.named(name), Scenes.named(name));
    }

    @ParameterizedTest(name = "{0} is cut off or too small in its first view")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void fillsItsFirstView(String name) {
        Scene scene = Scenes.named(name);
        Raster picture = picture(scene);
        int background = 0xFF000000 | scene.backgroundRgb();
        int seen = 0;
        for (int argb : picture.argb()) if (argb != background) seen++;
        double share = (double) seen / picture.argb().length;
        assertTrue(share > 0.05, name + " covers a share of " + share);
        if (name.equals("near-plane")) return;
        for (int x = 0; x < WIDTH; x++)
            for (int y : new int[] {0, HEIGHT - 1}) assertEquals(background, picture.argb(x, y));
        for (int y = 0; y < HEIGHT; y++)
            for (int x : new int[] {0, WIDTH - 1}) assertEquals(background, picture.argb(x, y));
    }

    @ParameterizedTest(name = "{0} has one colour: its light shines on nothing")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void isShaded(String name) {
        Set<Integer> colors = new HashSet<>();
        for (int argb : picture(Scenes.named(name)).argb()) colors.add(argb);
        assertTrue(colors.size() > 3, name + " has only " + colors.size() + " colours");
    }

    private static Raster picture(Scene scene) {
        var request =
                new RenderRequest(
                        scene,
                        Renderer.REFERENCE,
                        "flat",
                        "perspective",
                        scene.defaultCamera(),
                        WIDTH,
                        HEIGHT);
        return new Renderer().render(request, () -> false);
    }

    @ParameterizedTest(name = "{0}: a corner's normal points inwards")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void cornersLookTheWayTheirFaceDoes(String name) {
        Mesh mesh = Scenes.named(name).mesh();
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                double along =
                        mesh.normalX(f) * mesh.cornerNormal(f, k, 0)
                                + mesh.normalY(f) * mesh.cornerNormal(f, k, 1)
                                + mesh.normalZ(f) * mesh.cornerNormal(f, k, 2);
                assertTrue(along > 0.5, name + ", face " + f + ", corner " + k + ": " + along);
            }
    }

    @Test
    @DisplayName("boards lie in an order after all")
    void eachBoardIsOverTheNext() {
        Mesh mesh = Scenes.named("cyclic-overlap").mesh();
        int perBoard = mesh.faceCount() / 3;
        assertEquals(6, perBoard);
        for (int board = 0; board < 3; board++) {
            Vector3d up = end(mesh, board * perBoard, 1);
            Vector3d down = end(mesh, (board + 1) % 3 * perBoard, -1);
            assertTrue(up.z > 12 && down.z < -12, "board " + board + ": " + up + " over " + down);
            double apart = Math.hypot(up.x - down.x, up.y - down.y);
            assertTrue(apart < 100, "board " + board + " misses the next by " + apart);
        }
    }

    /** The middle of the higher or lower end of a board. */
    private static Vector3d end(Mesh mesh, int firstFace, int way) {
        var best = new Vector3d(0, 0, -1e9);
        for (int f = firstFace; f < firstFace + 6; f++) {
            var middle = new Vector3d();
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                middle.add(mesh.x(v), mesh.y(v), mesh.z(v));
            }
            middle.div(mesh.cornerCount(f));
            if (way * middle.z > way * best.z || best.z == -1e9) best = middle;
        }
        return best;
    }

    @ParameterizedTest(name = "detail {0} is taken for the usual one")
    @ValueSource(ints = {3, 5, 64})
    void detailCountsTheFacesRound(int detail) {
        int rings = Math.max(3, detail / 2);
        assertEquals(detail * rings, Scenes.named("sphere", detail).mesh().faceCount());
        assertEquals(detail * rings, Scenes.named("torus", detail).mesh().faceCount());
        for (String name : Scenes.namesWithDetail())
            assertEquals(name, Scenes.named(name, detail).name());
    }

    @ParameterizedTest(name = "detail {0} is made")
    @ValueSource(ints = {-1, 0, 2, 1025, Integer.MAX_VALUE})
    void refusesDetail(int detail) {
        var refusal =
                assertThrows(IllegalArgumentException.class, () -> Scenes.named("sphere", detail));
        assertEquals("detail must be from 3 to 1024, got " + detail, refusal.getMessage());
    }

    @Test
    @DisplayName("the house is made of more faces")
    void refusesDetailWhereNothingHasSteps() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> Scenes.named("house", 8));
        assertEquals(
                "scene 'house' takes no detail; "
                        + String.join(", ", Scenes.namesWithDetail())
                        + " do",
                refusal.getMessage());
    }

    @Test
    @DisplayName("the globe has a seam where its picture begins")
    void earthGoesRound() {
        for (double latitude = -1.497; latitude <= 1.5; latitude += 0.01) {
            int before = EarthColors.rgb(2 * Math.PI - 1e-9, latitude);
            int after = EarthColors.rgb(1e-9, latitude);
            for (int shift = 0; shift <= 16; shift += 8)
                assertEquals(
                        before >> shift & 255, after >> shift & 255, 1, "latitude " + latitude);
        }
    }
}
