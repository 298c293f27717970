package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

class VaseTest {
    private final Scene vase = Scenes.named("vase");
    private final Mesh mesh = vase.mesh();

    @Test
    @DisplayName("faces are missing or one too many")
    void hasTheCourseworksCounts() {
        assertEquals(301, mesh.vertexCount());
        assertEquals(300, mesh.faceCount());
        for (int f = 0; f < 300; f++)
            assertEquals(f < 270 ? 4 : 3, mesh.cornerCount(f), "corners of face " + f);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("vertices")
    void hasVertex(int vertex, double x, double y, double z) {
        assertEquals(x, mesh.x(vertex), 1e-12);
        assertEquals(y, mesh.y(vertex), 1e-12);
        assertEquals(z, mesh.z(vertex), 1e-12);
    }

    static Stream<Arguments> vertices() {
        double half = Math.sqrt(3) / 2;
        return Stream.of(
                argumentSet("sine and cosine are swapped", 0, 0, 50, -125),
                argumentSet("the longitude runs backwards", 5, 50 * half, 25, -125),
                argumentSet("the height runs to +125", 270, 0, 46, 100),
                argumentSet("radii are shifted by one", 90, 0, 94, -50),
                argumentSet("the bottom's centre is missing", 300, 0, 0, -125));
    }

    @Test
    @DisplayName("the seam between the last and the first meridian is open")
    void everyEdgeButTheRimHasTwoFaces() {
        var uses = new int[301][301];
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int a = mesh.corner(f, k);
                int b = mesh.corner(f, (k + 1) % mesh.cornerCount(f));
                uses[a][b]++;
            }
        for (int a = 0; a < 301; a++)
            for (int b = 0; b < 301; b++) {
                boolean rim = a >= 270 && a < 300 && b >= 270 && b < 300;
                if (uses[a][b] > 0 && !rim)
                    assertEquals(uses[a][b], uses[b][a], "edge " + a + "–" + b);
            }
    }

    @Test
    @DisplayName("a face is listed clockwise from outside")
    void normalsPointOutwards() {
        for (int f = 0; f < 270; f++) {
            int corner = mesh.corner(f, 0);
            double outward = mesh.normalX(f) * mesh.x(corner) + mesh.normalY(f) * mesh.y(corner);
            assertTrue(outward > 0, "face " + f);
        }
        for (int f = 270; f < 300; f++) assertEquals(-1, mesh.normalZ(f), 1e-12, "face " + f);
    }

    @Test
    @DisplayName("mean z is taken from other corners than the coursework's")
    void firstThreeCornersAreTheCourseworksAbc() {
        assertArrayEquals(new int[] {0, 1, 31}, firstThree(0));
        assertArrayEquals(new int[] {0, 29, 30}, firstThree(29));
        assertArrayEquals(new int[] {0, 1, 300}, firstThree(270));
        assertArrayEquals(new int[] {0, 29, 300}, firstThree(299));
    }

    private int[] firstThree(int face) {
        return IntStream.range(0, 3).map(k -> mesh.corner(face, k)).sorted().toArray();
    }

    @Test
    @DisplayName("side and bottom colours are swapped")
    void hasTheCourseworksColorsAndView() {
        int[] rgb = IntStream.range(0, mesh.faceCount()).map(f -> vase.finish(f).rgb()).toArray();
        assertTrue(Arrays.stream(rgb, 0, 270).allMatch(c -> c == (255 << 16 | 255 << 8 | 204)));
        assertTrue(Arrays.stream(rgb, 270, 300).allMatch(c -> c == (209 << 16 | 154 << 8 | 65)));
        assertEquals(new SphericalView(Math.PI / 9, Math.PI * 4 / 3, 500), vase.defaultCamera());
        assertEquals(1, vase.pictureScale());
    }
}
