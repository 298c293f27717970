package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.catalogue.Scenes;

class HouseTest {
    private final Mesh mesh = Scenes.named("house").mesh();

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
        assertEquals(
                "no scene 'vas'; there are "
                        + String.join(", ", Scenes.names())
                        + "; did you mean 'vase'?",
                refusal.getMessage());
    }
}
