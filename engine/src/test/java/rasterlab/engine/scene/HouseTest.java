package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class HouseTest {
    private final Mesh mesh = Scenes.named("house").mesh();

    @Test
    @DisplayName("the scale is left out")
    void worldTableIsTheTextbooksTimes16() {
        double[][] world = HouseStages.world();
        assertEquals(10, world.length);
        assertArrayEquals(new double[] {0, 0, 0}, world[0], 1e-12);
        assertArrayEquals(new double[] {128, 96, 80}, world[6], 1e-12);
        assertArrayEquals(new double[] {64, 96, 144}, world[9], 1e-12);
    }

    /**
     * By hand for vertex 9, world (64, 0, 144): about x by −90° (64, 144, 0); about y by −40° (64
     * cos 40°, 144, 64 sin(−40°)·(−1)) with the textbook's −sin in the first row; about x by 10°.
     */
    @Test
    @DisplayName("a rotation turns the other way")
    void eyeTableFollowsTheThreeRotations() {
        double c40 = Math.cos(Math.toRadians(40));
        double s40 = Math.sin(Math.toRadians(40));
        double c10 = Math.cos(Math.toRadians(10));
        double s10 = Math.sin(Math.toRadians(10));
        double[] turned = {64 * c40, 144, 64 * s40};
        double[] expected = {
            turned[0], turned[1] * c10 - turned[2] * s10, turned[1] * s10 + turned[2] * c10
        };
        assertArrayEquals(expected, HouseStages.eye()[8], 1e-9);
    }

    @Test
    @DisplayName("the shift comes after the division")
    void screenTableDividesTheShiftedEyeTable() {
        double[][] eye = HouseStages.eye();
        double[][] screen = HouseStages.screen();
        for (int v = 0; v < 10; v++) {
            double h = 1 - eye[v][2] / 700;
            assertEquals(eye[v][0] / h, screen[v][0], 1e-9, "x of vertex " + (v + 1));
            assertEquals((eye[v][1] - 150) / h, screen[v][1], 1e-9, "y of vertex " + (v + 1));
        }
    }

    @Test
    @DisplayName("a face is listed clockwise from outside")
    void normalsPointAwayFromTheMiddle() {
        assertEquals(7, mesh.faceCount());
        for (int f = 0; f < 7; f++) {
            int corner = mesh.corner(f, 0);
            double outward =
                    mesh.normalX(f) * mesh.x(corner)
                            + mesh.normalY(f) * mesh.y(corner)
                            + mesh.normalZ(f) * mesh.z(corner);
            assertTrue(outward > 0, "face " + f);
        }
    }

    @Test
    @DisplayName("the house has a hole")
    void everyEdgeIsUsedOnceInEachDirection() {
        int[][] uses = new int[10][10];
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                uses[mesh.corner(f, k)][mesh.corner(f, (k + 1) % mesh.cornerCount(f))]++;
        for (int a = 0; a < 10; a++)
            for (int b = 0; b < 10; b++) {
                assertTrue(uses[a][b] <= 1, "edge " + a + "–" + b);
                assertEquals(uses[a][b], uses[b][a], "edge " + a + "–" + b);
            }
    }

    @Test
    @DisplayName("an unknown scene is null")
    void namesTheKnownScenes() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> Scenes.named("vas"));
        assertEquals("no scene 'vas'; there are vase, house", refusal.getMessage());
    }
}
