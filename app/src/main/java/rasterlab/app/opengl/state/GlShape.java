package rasterlab.app.opengl.state;

/**
 * A shape of the scene: triangles or lines over shared vertices; arrays are not copied and nobody
 * writes to them.
 *
 * @param name part of the calls' log
 * @param lines whether indices are pairs of ends rather than triangles
 * @param lit whether light falls on it; if not, it has its own colour always
 * @param xyz vertices in the world
 * @param normals of length 1
 * @param st texture coordinates
 * @param rgb colours of the vertices, shares
 * @param indices counter-clockwise seen from outside, for triangles
 */
public record GlShape(
        String name,
        boolean lines,
        boolean lit,
        float[] xyz,
        float[] normals,
        float[] st,
        float[] rgb,
        int[] indices) {
    public int vertexCount() {
        return xyz.length / 3;
    }

    /** The kind of primitives. */
    public GlName mode() {
        return lines ? GlName.GL_LINES : GlName.GL_TRIANGLES;
    }

    /** This shape made smaller and moved. */
    GlShape scaledTo(double radius, double x, double y, double z) {
        float[] moved = new float[xyz.length];
        for (int i = 0; i < xyz.length; i += 3) {
            moved[i] = (float) (xyz[i] * radius + x);
            moved[i + 1] = (float) (xyz[i + 1] * radius + y);
            moved[i + 2] = (float) (xyz[i + 2] * radius + z);
        }
        return new GlShape(name, lines, lit, moved, normals, st, rgb, indices);
    }
}
