package rasterlab.app.opengl.state;

import java.awt.Color;
import java.util.List;
import rasterlab.engine.texture.SphereMapping;

/** The shapes of the lab's scenes. */
final class GlShapes {
    private static final int MERIDIANS = 18;
    private static final int PARALLELS = 12;
    private static final double SPHERE = 1.5;
    private static final int SIDES = 48;
    private static final int RINGS = 6;
    private static final double TUBE = 0.7;
    private static final double HALF_HEIGHT = 0.9;
    private static final double QUAD = 1.3;
    private static final double LAMP = 0.05;
    private static final double GLOBE = 1.35;

    private GlShapes() {}

    /** Meridians and parallels of a sphere about the y axis, as lines. */
    static GlShape wireSphere() {
        SphereMapping sphere = SphereMapping.of(MERIDIANS, PARALLELS);
        int columns = MERIDIANS + 1;
        int[] lines = new int[2 * MERIDIANS * (2 * PARALLELS - 1)];
        int at = 0;
        for (int row = 0; row < PARALLELS; row++)
            for (int column = 0; column < MERIDIANS; column++) {
                int here = row * columns + column;
                lines[at++] = here;
                lines[at++] = here + columns;
                if (row == 0) continue;
                lines[at++] = here;
                lines[at++] = here + 1;
            }
        float[] normals = upright(sphere.xyz());
        float[] rgb = new float[normals.length];
        for (int i = 0; i < rgb.length; i += 3)
            paint(rgb, i, Color.HSBtoRGB(0.55f + 0.1f * normals[i + 1], 0.35f, 1));
        var unit =
                new GlShape(
                        "sphere", true, true, normals, normals, floats(sphere.st()), rgb, lines);
        return unit.scaledTo(SPHERE, 0, 0, 0);
    }

    /** A globe whose colours run with the normals. */
    static GlShape globe() {
        return ball("globe", true, 36, 18).scaledTo(GLOBE, 0, 0, 0);
    }

    /** A small ball where a light stands, in the light's colour. */
    static GlShape lamp(double[] color, double x, double y, double z) {
        GlShape ball = ball("lamp", false, 12, 8);
        float[] rgb = new float[ball.xyz().length];
        for (int i = 0; i < rgb.length; i++) rgb[i] = (float) color[i % 3];
        return new GlShape(
                        "lamp",
                        false,
                        false,
                        ball.xyz(),
                        ball.normals(),
                        ball.st(),
                        rgb,
                        ball.indices())
                .scaledTo(LAMP, x, y, z);
    }

    private static GlShape ball(String name, boolean lit, int meridians, int parallels) {
        SphereMapping sphere = SphereMapping.of(meridians, parallels);
        float[] normals = upright(sphere.xyz());
        float[] rgb = new float[normals.length];
        for (int i = 0; i < rgb.length; i++) rgb[i] = 0.5f + 0.5f * normals[i];
        return new GlShape(
                name, false, lit, normals, normals, floats(sphere.st()), rgb, sphere.triangles());
    }

    /** A tube about the y axis, open above and below; its outer side is the front. */
    static GlShape cylinder() {
        int columns = SIDES + 1;
        int vertices = columns * (RINGS + 1);
        var xyz = new float[3 * vertices];
        var normals = new float[3 * vertices];
        var st = new float[2 * vertices];
        var rgb = new float[3 * vertices];
        for (int v = 0; v < vertices; v++) {
            int column = v % columns;
            double around = 2 * Math.PI * (column % SIDES) / SIDES;
            double up = (double) (v / columns) / RINGS;
            normals[3 * v] = (float) Math.sin(around);
            normals[3 * v + 2] = (float) Math.cos(around);
            xyz[3 * v] = (float) (TUBE * Math.sin(around));
            xyz[3 * v + 1] = (float) (HALF_HEIGHT * (2 * up - 1));
            xyz[3 * v + 2] = (float) (TUBE * Math.cos(around));
            st[2 * v] = (float) column / SIDES;
            st[2 * v + 1] = (float) up;
            paint(rgb, 3 * v, Color.HSBtoRGB((float) column / SIDES, 0.7f, 1));
        }
        return new GlShape("cylinder", false, true, xyz, normals, st, rgb, strips(SIDES, RINGS));
    }

    private static int[] strips(int columns, int rows) {
        var triangles = new int[6 * columns * rows];
        int at = 0;
        for (int row = 0; row < rows; row++)
            for (int column = 0; column < columns; column++) {
                int here = row * (columns + 1) + column;
                int above = here + columns + 1;
                for (int corner : new int[] {here, here + 1, above + 1, here, above + 1, above})
                    triangles[at++] = corner;
            }
        return triangles;
    }

    /**
     * A square that faces the eye.
     *
     * @param uneven whether the texture coordinates of its corners are no square
     */
    static GlShape quad(boolean uneven) {
        float size = (float) QUAD;
        float[] xyz = {-size, -size, 0, size, -size, 0, size, size, 0, -size, size, 0};
        float[] normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
        float[] even = {0, 0, 2, 0, 2, 2, 0, 2};
        float[] other = {-0.5f, 0, 2, 0.25f, 1.25f, 1.5f, 0.25f, 2};
        float[] rgb = {1, 0.4f, 0.4f, 0.4f, 1, 0.4f, 0.4f, 0.4f, 1, 1, 1, 1};
        int[] triangles = {0, 1, 2, 0, 2, 3};
        return new GlShape(
                "quad", false, true, xyz, normals, uneven ? other : even, rgb, triangles);
    }

    static List<GlShape> of(GlChoice choice) {
        return switch (choice.get(Setting.SCENE)) {
            case "quad" -> List.of(quad(choice.is(Setting.COORDINATES, "uneven")));
            case "globe" -> List.of(globe());
            default -> List.of(cylinder(), wireSphere());
        };
    }

    /** The positions turned from poles along z to poles along y. */
    private static float[] upright(double[] xyz) {
        float[] turned = new float[xyz.length];
        for (int i = 0; i < xyz.length; i += 3) {
            turned[i] = (float) xyz[i + 1];
            turned[i + 1] = (float) xyz[i + 2];
            turned[i + 2] = (float) xyz[i];
        }
        return turned;
    }

    private static float[] floats(double[] values) {
        float[] copy = new float[values.length];
        for (int i = 0; i < values.length; i++) copy[i] = (float) values[i];
        return copy;
    }

    private static void paint(float[] rgb, int at, int color) {
        for (int c = 0; c < 3; c++) rgb[at + c] = (color >> 16 - 8 * c & 255) / 255f;
    }
}
