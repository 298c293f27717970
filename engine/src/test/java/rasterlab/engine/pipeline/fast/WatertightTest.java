package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.transform.GlMatrices;

/** Very many random meshes: all of them with {@code -Drasterlab.full=true}. */
@Tag("slow")
class WatertightTest {
    private static final int MESHES = Boolean.getBoolean("rasterlab.full") ? 100_000 : 3_000;
    private static final int SIDE = 48;

    /**
     * A closed surface shows each pixel as many fronts as backs, however it is folded: a pixel that
     * two triangles at an edge both own, or neither, breaks this.
     */
    @Test
    void frontsAndBacksOfClosedMeshesBalance() {
        var view = PixelSpace.view(SIDE, SIDE, Culling.NONE);
        for (int seed = 0; seed < MESHES; seed++) {
            var random = new Random(seed);
            int rings = 3 + random.nextInt(4);
            int sides = 3 + random.nextInt(4);
            float[] xy = new float[2 * rings * sides];
            for (int i = 0; i < xy.length; i++) xy[i] = coordinate(random);
            makeSlivers(xy, random);
            var coverage = Coverage.of(PixelSpace.mesh(xy, closed(rings, sides)), view, SIDE, SIDE);
            for (int i = 0; i < SIDE * SIDE; i++)
                if (coverage.counterClockwise[i] != coverage.clockwise[i])
                    assertEquals(
                            coverage.counterClockwise[i],
                            coverage.clockwise[i],
                            "seed %d, pixel (%d, %d)".formatted(seed, i % SIDE, i / SIDE));
        }
    }

    /**
     * A coordinate on a centre, halfway, on a step of 1/256, anywhere, or outside beyond the guard.
     */
    private static float coordinate(Random random) {
        int whole = random.nextInt(SIDE + 8) - 4;
        return switch (random.nextInt(8)) {
            case 0, 1 -> whole;
            case 2 -> whole + 0.5f;
            case 3, 4 -> whole + random.nextInt(256) / 256f;
            case 5, 6 -> random.nextFloat() * SIDE;
            default -> (random.nextFloat() - 0.5f) * 3 * SIDE;
        };
    }

    /** Some vertices fall together, some lie a step beside another. */
    private static void makeSlivers(float[] xy, Random random) {
        for (int i = 2; i < xy.length; i += 2) {
            int from = 2 * random.nextInt(i / 2);
            int kind = random.nextInt(8);
            if (kind > 1) continue;
            xy[i] = xy[from] + kind * (random.nextInt(3) - 1) / 256f;
            xy[i + 1] = xy[from + 1] + kind * (random.nextInt(3) - 1) / 256f;
        }
    }

    /** The triangles of a torus. */
    private static int[] closed(int rings, int sides) {
        int[] triangles = new int[6 * rings * sides];
        int at = 0;
        for (int i = 0; i < rings; i++)
            for (int j = 0; j < sides; j++) {
                int here = i * sides + j;
                int right = i * sides + (j + 1) % sides;
                int below = (i + 1) % rings * sides + j;
                int beyond = (i + 1) % rings * sides + (j + 1) % sides;
                for (int v : new int[] {here, below, beyond, here, beyond, right})
                    triangles[at++] = v;
            }
        return triangles;
    }

    /** Triangles about a hub in one plane that goes through near, far and the sides of the view. */
    @Test
    void clippedFansOwnNoPixelTwiceAndMissNone() {
        int meshes = MESHES / 10;
        int missed = 0;
        for (int seed = 0; seed < meshes; seed++) {
            var random = new Random(seed);
            var view =
                    new TriangleView(
                            new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.3, -3, 1),
                            GlMatrices.perspective(60, 1, 1, 6),
                            List.of(new double[] {1, 0.3, 0.2, 1.3}),
                            Culling.NONE);
            var fan = Coverage.of(floor(random, 3 + random.nextInt(9)), view, SIDE, SIDE);
            for (int i = 0; i < SIDE * SIDE; i++) {
                int owners = fan.counterClockwise[i] + fan.clockwise[i];
                assertEquals(
                        Math.min(owners, 1),
                        owners,
                        "seed %d, pixel (%d, %d)".formatted(seed, i % SIDE, i / SIDE));
                if (owners == 0 && between(fan, i)) missed++;
            }
        }
        assertEquals(0, missed, "pixels inside that nobody owns");
    }

    /** Whether the pixels on both sides and above and below are owned: the fan is convex. */
    private static boolean between(Coverage fan, int i) {
        int x = i % SIDE;
        int y = i / SIDE;
        if (x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1) return false;
        for (int beside : new int[] {i - 1, i + 1, i - SIDE, i + SIDE})
            if (fan.counterClockwise[beside] + fan.clockwise[beside] == 0) return false;
        return true;
    }

    /** A convex floor of 5 units about the eye's foot, its hub anywhere near the middle. */
    private static TriangleMesh floor(Random random, int corners) {
        float[] x = new float[corners + 1];
        float[] y = new float[corners + 1];
        float[] z = new float[corners + 1];
        int[] triangles = new int[3 * corners];
        x[corners] = random.nextFloat() * 0.4f;
        z[corners] = random.nextFloat() * 0.4f;
        double turn = random.nextDouble();
        for (int k = 0; k < corners; k++) {
            double angle = 2 * Math.PI * (k + turn) / corners;
            x[k] = (float) (5 * Math.cos(angle));
            z[k] = (float) (5 * Math.sin(angle));
            triangles[3 * k] = corners;
            triangles[3 * k + 1] = k;
            triangles[3 * k + 2] = (k + 1) % corners;
        }
        return TriangleMesh.of(x, y, z, triangles);
    }
}
