package rasterlab.engine.scene.obj;

import java.util.Arrays;
import rasterlab.engine.polygon.triangulation.EarClipping;
import rasterlab.engine.scene.Mesh;

/**
 * Makes faces that a {@link Mesh} takes out of any: flat convex ones stay, others are cut into
 * triangles, seen along their normal's largest coordinate, and what has no area is left out. What
 * cannot be cut so, since it crosses itself or has too many corners, becomes a fan.
 */
final class FaceCutter {
    /**
     * Cutting takes time of up to the square of the corners, so of faces with more of them only so
     * many are cut that the squares stay below {@link #MOST_SQUARES}.
     */
    static final int MOST_CORNERS = 1000;

    static final long MOST_SQUARES = 400_000_000;

    /** Twice the area over the squared size. */
    private static final double TOLERANCE = Mesh.TOLERANCE;

    /**
     * The ratio above which a triangle's plane is so sure that a mesh takes it without being asked.
     */
    private static final double SURE = 1e-6;

    private final TextLines lines;
    private final Notes notes;
    private final Doubles positions;
    private final Faces faces;
    private final double[] normal = new double[3];
    private final double[] origin = new double[3];
    private int exponent;
    private boolean cancelsOut;
    private boolean surelyTaken;
    private long squares;

    FaceCutter(TextLines lines, Notes notes, Doubles positions, Faces faces) {
        this.lines = lines;
        this.notes = notes;
        this.positions = positions;
        this.faces = faces;
    }

    void add(FaceLine line, int material, int smoothing) {
        measure(line);
        int[] corners = apart(line);
        boolean area = hasArea(line, corners);
        if (!area && !cancelsOut) {
            leaveOut("face");
        } else if (surelyTaken || area && isTaken(line, corners)) {
            keep(line, corners, material, smoothing);
        } else {
            int[] triples = area ? triangles(line, corners) : fan(corners.length);
            for (int i = 0; i < triples.length; i += 3) {
                int[] triangle = {
                    corners[triples[i]], corners[triples[i + 1]], corners[triples[i + 2]]
                };
                if (isTaken(line, triangle)) keep(line, triangle, material, smoothing);
                else leaveOut("triangle of a face");
            }
        }
    }

    private int[] fan(int corners) {
        notes.count(
                "a face that crosses itself, or has too many corners to be cut, was drawn as a fan"
                        + " of triangles",
                lines);
        int[] triples = new int[3 * (corners - 2)];
        for (int t = 0; t < corners - 2; t++) {
            triples[3 * t + 1] = t + 1;
            triples[3 * t + 2] = t + 2;
        }
        return triples;
    }

    private void leaveOut(String what) {
        String why = what + " without area or too thin to be seen was left out";
        notes.leaveOut(why, why, lines);
    }

    private void keep(FaceLine line, int[] corners, int material, int smoothing) {
        for (int k : corners)
            faces.corner(line.vertex.get(k), line.texture.get(k), line.normal.get(k));
        faces.close(material, smoothing);
    }

    /** The corners without those that lie where the next one does. */
    private int[] apart(FaceLine line) {
        var kept = new Ints();
        int n = line.vertex.size();
        for (int k = 0; k < n; k++) {
            boolean differs = false;
            for (int axis = 0; axis < 3; axis++)
                differs |= at(line, k, axis) != at(line, (k + 1) % n, axis);
            if (differs) kept.add(k);
        }
        return kept.all();
    }

    /** Measures a face; of a tiny one {@link #at} is counted from its first corner and scaled. */
    private void measure(FaceLine line) {
        exponent = 0;
        double longest = 0;
        for (int k = 1; k < line.vertex.size(); k++)
            for (double length : edge(line, 0, k)) longest = Math.max(longest, Math.abs(length));
        for (int axis = 0; axis < 3; axis++) origin[axis] = at(line, 0, axis);
        exponent = TinyLengths.exponent(longest);
    }

    private double at(FaceLine line, int corner, int axis) {
        double at = positions.get(3 * line.vertex.get(corner) + axis);
        return exponent == 0 ? at : Math.scalb(at - origin[axis], exponent);
    }

    /**
     * Sums the fan's cross products into {@link #normal}. Where they cancel out though the corners
     * do not lie on one line, the face covers as much from either side.
     */
    private boolean hasArea(FaceLine line, int[] corners) {
        Arrays.fill(normal, 0);
        double size = 0;
        double sum = 0;
        for (int k = 1; k + 1 < corners.length; k++) {
            double[] a = edge(line, corners[0], corners[k]);
            double[] b = edge(line, corners[0], corners[k + 1]);
            double[] cross = {
                a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
            };
            for (int axis = 0; axis < 3; axis++) normal[axis] += cross[axis];
            size = Math.max(size, Math.max(square(a), square(b)));
            sum += Math.sqrt(square(cross));
        }
        double length = Math.sqrt(square(normal));
        boolean area = length > TOLERANCE * size;
        surelyTaken = corners.length == 3 && length > SURE * size && length > 1e-200;
        cancelsOut = !area && sum > 2 * TOLERANCE * size;
        return area;
    }

    private double[] edge(FaceLine line, int from, int to) {
        double[] edge = new double[3];
        for (int axis = 0; axis < 3; axis++) edge[axis] = at(line, to, axis) - at(line, from, axis);
        return edge;
    }

    private static double square(double[] v) {
        return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    }

    private boolean isTaken(FaceLine line, int[] corners) {
        double[] xyz = new double[3 * corners.length];
        int[] face = new int[corners.length];
        for (int k = 0; k < corners.length; k++) {
            face[k] = k;
            for (int axis = 0; axis < 3; axis++) xyz[3 * k + axis] = at(line, corners[k], axis);
        }
        try {
            return new Mesh(xyz, new int[][] {face}).faceCount() == 1;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    private int[] triangles(FaceLine line, int[] corners) {
        if (corners.length > MOST_CORNERS) squares += (long) corners.length * corners.length;
        if (squares > MOST_SQUARES && corners.length > MOST_CORNERS) return fan(corners.length);
        int away = 0;
        for (int axis = 1; axis < 3; axis++)
            if (Math.abs(normal[axis]) > Math.abs(normal[away])) away = axis;
        int right = (away + (normal[away] > 0 ? 1 : 2)) % 3;
        int up = 3 - away - right;
        double[] x = new double[corners.length];
        double[] y = new double[corners.length];
        for (int k = 0; k < corners.length; k++) {
            x[k] = at(line, corners[k], right);
            y[k] = at(line, corners[k], up);
        }
        try {
            int[] triples = new EarClipping().triangulate(x, y);
            notes.count("a face that is not flat or not convex was cut into triangles", lines);
            return triples;
        } catch (IllegalArgumentException refused) {
            return fan(corners.length);
        }
    }
}
