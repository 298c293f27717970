package rasterlab.engine.scene.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.scene.Mesh;

class JoinedBlocksTest {
    private record Edge(int from, int to) {}

    @ParameterizedTest(name = "a gap opens between cells and blocks of a {0}")
    @CsvSource({
        "sphere, 24, 12, 4",
        "sphere, 23, 11, 3",
        "torus, 24, 12, 4",
        "torus, 25, 13, 5",
        "cylinder, 20, 6, 2",
        "cube, 9, 9, 3",
        "vase, 26, 14, 4"
    })
    void blocksLeaveNoGap(String name, int u, int v, int side) {
        SceneShape shape = shape(name);
        for (int seed = 1; seed <= 20; seed++) {
            Mesh mesh = shape.faces(u, v, scattered(side, seed));
            Map<Edge, Integer> edges = new HashMap<>();
            for (int f = 0; f < mesh.faceCount(); f++)
                for (int k = 0; k < mesh.cornerCount(f); k++) {
                    int next = (k + 1) % mesh.cornerCount(f);
                    edges.merge(new Edge(mesh.corner(f, k), mesh.corner(f, next)), 1, Integer::sum);
                }
            String place = "seed " + seed;
            edges.forEach(
                    (edge, count) -> {
                        assertEquals(1, count, place + ": " + edge);
                        assertTrue(
                                edges.containsKey(new Edge(edge.to, edge.from)),
                                place + ": nothing is beside " + edge);
                    });
        }
    }

    @Test
    void blocksAmongJoinedOnesAreOneFaceEach() {
        JoinedBlocks all = blocks(4, (patch, column, row) -> true);
        Mesh mesh = new Torus(10, 3).faces(24, 12, all);
        assertEquals(6 * 3, mesh.faceCount());
    }

    @Test
    void noBlockJoinedIsTheMeshItself() {
        SceneShape vase = shape("vase");
        Mesh mesh = vase.faces(12, 8, blocks(4, (patch, column, row) -> false));
        assertEquals(vase.faces(12, 8).faceCount(), mesh.faceCount());
        assertEquals(vase.faces(12, 8).vertexCount(), mesh.vertexCount());
    }

    @Test
    void placesKeepTheirNumbers() {
        var places = new NumberedPlaces();
        var random = new Random(5);
        double[] x = random.doubles(3000).toArray();
        for (int i = 0; i < x.length; i++) assertEquals(i, places.number(x[i], -x[i], 1));
        for (int i = 0; i < x.length; i++) assertEquals(i, places.number(x[i], -x[i], 1));
        assertEquals(x.length, places.number(0.0, -0.0, 0.0));
        assertEquals(x.length, places.number(-0.0, 0.0, -0.0));
        assertEquals(3 * (x.length + 1), places.coordinates().length);
        assertEquals(x[2999], places.coordinates()[3 * 2999]);
    }

    private static SceneShape shape(String name) {
        return switch (name) {
            case "sphere" -> new Sphere(10);
            case "torus" -> new Torus(10, 3);
            case "cylinder" -> Cylinder.closed(5, 12);
            case "cube" -> new Cube(4);
            default ->
                    new Revolution(
                            new double[] {-4, -1, 2, 5},
                            new double[] {3, 5, 2, 3},
                            SplineEnds.natural(),
                            true,
                            true);
        };
    }

    private interface Choice {
        boolean joined(int patch, int column, int row);
    }

    /** About half of the blocks, the same ones each time that is asked. */
    private static JoinedBlocks scattered(int side, int seed) {
        return blocks(
                side,
                (patch, column, row) ->
                        new Random(31L * (31L * (31L * seed + patch) + column) + row).nextInt(64)
                                < 32);
    }

    private static JoinedBlocks blocks(int side, Choice choice) {
        return new JoinedBlocks() {
            @Override
            public int side() {
                return side;
            }

            @Override
            public boolean joined(int patch, int column, int row) {
                return choice.joined(patch, column, row);
            }
        };
    }
}
