package rasterlab.engine.sight;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.scene.Mesh;

class FaceGapsTest {
    /** A square in the plane z = 0, and a triangle. */
    @ParameterizedTest(name = "{10}")
    @CsvSource({
        "0,0,3, 5,0,4, 0,5,4, 3, corner over the middle of a face",
        "13,0,2, 20,0,2, 20,5,2, 3.605551275463989, corner beside an edge",
        "0,0,3, 5,0,-3, 0,5,3, 0, face that passes through another",
        "-5,12,-9, -5,12,9, -5,20,0, 2, edge that crosses a line beside a face",
        "-20,0,4, 20,0,4, 0,9,6, 4, edge over a face and its corners outside",
        "10,10,0, 20,10,0, 20,20,0, 0, corner at the same place",
        "-5,5,3, -5,6,9, -6,5,9, 3, corner over the second triangle of a fan",
        "0,20,3, 20,0,3, 20,20,-17, 1.7320508075688772, corner of the first face under the second",
        "13,1,2, 20,8,2, 20,15,9, 3.605551275463989, lines nearest before an edge begins",
        "8,20,2, 20,8,2, 20,20,9, 6, lines nearest after an edge has ended",
        "13,0,0, 20,0,0, 20,5,0, 3, face in the same plane"
    })
    void leastDistance(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double gap,
            String name) {
        double[] xyz = {
            -10, -10, 0, 10, -10, 0, 10, 10, 0, -10, 10, 0, ax, ay, az, bx, by, bz, cx, cy, cz
        };
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6}});
        assertEquals(gap, FaceGaps.least(mesh), 1e-12);
    }

    @Test
    @DisplayName("a nearer pair is passed over once a farther one is known, or is never looked at")
    void leastOfThreeFaces() {
        for (double[] heights : new double[][] {{5, 3}, {3, 5}, {5, 2.5}}) {
            double[] xyz = {
                -10,
                -10,
                0,
                10,
                -10,
                0,
                10,
                10,
                0,
                -10,
                10,
                0, //
                0,
                -5,
                heights[0],
                5,
                -5,
                9,
                0,
                -9,
                9, //
                0,
                5,
                heights[1],
                5,
                5,
                9,
                0,
                9,
                9
            };
            var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
            assertEquals(Math.min(heights[0], heights[1]), FaceGaps.least(mesh), 1e-12);
        }
    }

    @Test
    @DisplayName("the nearest two are not looked for beyond the pairs of the first face")
    void leastOfTheLastTwoFaces() {
        double[] xyz = {
            0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 9, 1, 0, 9, 0, 1, 9, 0, 0, 11, 1, 0, 11, 0, 1, 11
        };
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
        assertEquals(2, FaceGaps.least(mesh), 1e-12);
    }

    @Test
    @DisplayName("a corner on the line of its neighbours makes a triangle that has no plane")
    void cornersInALineCount() {
        double[] xyz = {
            -10, -10, 0, 0, -10, 0, 10, -10, 0, 10, 10, 0, -10, 10, 0, 0, 0, 3, 5, 0, 4, 0, 5, 4
        };
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3, 4}, {5, 6, 7}});
        assertEquals(3, FaceGaps.least(mesh), 1e-12);
    }

    @Test
    void oneFaceIsInfinitelyFarFromAllOthers() {
        double[] xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2}});
        assertEquals(Double.POSITIVE_INFINITY, FaceGaps.least(mesh));
    }
}
