package rasterlab.engine.visibility.faces;

import java.util.ArrayList;
import java.util.List;

/** Bodies to judge; faces go counter-clockwise seen from outside. */
final class Bodies {
    private Bodies() {}

    /** The cube [−1, 1]³: bottom, top, front (y = −1), right, back, left. */
    static Body cube(double... eye) {
        double[] xyz = {
            -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1
        };
        return Body.seenFrom(
                eye,
                xyz,
                new int[] {0, 3, 2, 1},
                new int[] {4, 5, 6, 7},
                new int[] {0, 1, 5, 4},
                new int[] {1, 2, 6, 5},
                new int[] {2, 3, 7, 6},
                new int[] {3, 0, 4, 7});
    }

    /**
     * A block with an L for its base, corners (0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4), one
     * unit high: base, top, then the six sides from y = 0 on.
     */
    static Body corner(double... eye) {
        double[] base = {0, 0, 4, 0, 4, 1, 1, 1, 1, 4, 0, 4};
        var xyz = new double[36];
        for (int i = 0; i < 12; i++) {
            xyz[3 * i] = base[2 * (i % 6)];
            xyz[3 * i + 1] = base[2 * (i % 6) + 1];
            xyz[3 * i + 2] = i / 6;
        }
        List<int[]> faces = new ArrayList<>();
        faces.add(new int[] {5, 4, 3, 2, 1, 0});
        faces.add(new int[] {6, 7, 8, 9, 10, 11});
        for (int i = 0; i < 6; i++) faces.add(new int[] {i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
        return Body.seenFrom(eye, xyz, faces.toArray(int[][]::new));
    }

    /**
     * A sphere of quadrilaterals between meridians and parallels, triangles at the poles.
     *
     * @param parallels rows of faces from pole to pole
     */
    static Body sphere(int meridians, int parallels, double radius, double... eye) {
        int rings = parallels - 1;
        var xyz = new double[3 * (rings * meridians + 2)];
        for (int v = 0; v < rings * meridians; v++) {
            double fromPole = Math.PI * (v / meridians + 1) / parallels;
            double longitude = 2 * Math.PI * (v % meridians) / meridians;
            xyz[3 * v] = radius * Math.sin(fromPole) * Math.cos(longitude);
            xyz[3 * v + 1] = radius * Math.sin(fromPole) * Math.sin(longitude);
            xyz[3 * v + 2] = radius * Math.cos(fromPole);
        }
        int north = rings * meridians;
        xyz[3 * north + 2] = radius;
        xyz[3 * north + 5] = -radius;
        var faces = new int[meridians * parallels][];
        for (int f = 0; f < faces.length; f++) {
            int row = f / meridians;
            int low = row * meridians + f % meridians;
            int lowNext = row * meridians + (f + 1) % meridians;
            if (row == 0) faces[f] = new int[] {north, low, lowNext};
            else if (row == rings)
                faces[f] = new int[] {low - meridians, north + 1, lowNext - meridians};
            else faces[f] = new int[] {low - meridians, low, lowNext, lowNext - meridians};
        }
        return Body.seenFrom(eye, xyz, faces);
    }
}
