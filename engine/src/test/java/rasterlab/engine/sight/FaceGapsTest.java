package rasterlab.engine.sight;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
        "10,10,0, 20,10,0, 20,20,0, 0, corner at the same place"
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
}
