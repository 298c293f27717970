package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TextureSphereTest {
    @ParameterizedTest(name = "a strip of {0}×{1} runs through the map backwards")
    @CsvSource({"3,2", "8,4", "36,18"})
    void noFaceIsWiderThanItsStripOfTheMap(int meridians, int parallels) {
        SphereMapping sphere = SphereMapping.of(meridians, parallels);
        int[] corners = sphere.triangles();
        assertEquals(6 * meridians * (parallels - 1), corners.length);
        for (int face = 0; face < corners.length; face += 3) {
            double least = 1;
            double most = 0;
            for (int k = face; k < face + 3; k++) {
                least = Math.min(least, sphere.st()[2 * corners[k]]);
                most = Math.max(most, sphere.st()[2 * corners[k]]);
            }
            assertEquals(1.0 / meridians, most - least, 1e-12, "face " + face / 3);
        }
    }

    @Test
    void firstMeridianStandsTwiceInOnePlace() {
        SphereMapping sphere = SphereMapping.of(7, 5);
        for (int row = 1; row < 5; row++) {
            int first = 8 * row;
            int last = first + 7;
            for (int c = 0; c < 3; c++)
                assertEquals(sphere.xyz()[3 * first + c], sphere.xyz()[3 * last + c]);
            assertEquals(0, sphere.st()[2 * first]);
            assertEquals(1, sphere.st()[2 * last]);
        }
    }

    @Test
    void mapIsNotSheared() {
        SphereMapping sphere = SphereMapping.of(4, 2);
        double[] st = sphere.st();
        assertEquals(0.125, st[0]);
        assertEquals(0, st[1]);
        assertEquals(0.125, st[2 * 10]);
        assertEquals(1, st[2 * 10 + 1]);
    }

    @Test
    void everyFaceIsSeenFromOutside() {
        SphereMapping sphere = SphereMapping.of(12, 6);
        int[] corners = sphere.triangles();
        for (int face = 0; face < corners.length; face += 3)
            assertTrue(volume(sphere.xyz(), corners, face) > 0, "face " + face / 3);
    }

    /** Six times the volume of the face and the sphere's centre. */
    private static double volume(double[] xyz, int[] corners, int face) {
        int a = 3 * corners[face];
        int b = 3 * corners[face + 1];
        int c = 3 * corners[face + 2];
        return xyz[a] * (xyz[b + 1] * xyz[c + 2] - xyz[b + 2] * xyz[c + 1])
                + xyz[a + 1] * (xyz[b + 2] * xyz[c] - xyz[b] * xyz[c + 2])
                + xyz[a + 2] * (xyz[b] * xyz[c + 1] - xyz[b + 1] * xyz[c]);
    }

    @Test
    void refusesASphereOfTwoMeridians() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> SphereMapping.of(2, 5));
        assertEquals("meridians must be from 3 to 2048, got 2", refusal.getMessage());
    }
}
