package rasterlab.engine.scene;

/** Some faces of a mesh, with what their corners have, over the same vertices. */
final class MeshPart {
    private MeshPart() {}

    static Mesh of(Mesh whole, int[] faces) {
        var corners = new int[faces.length][];
        int all = 0;
        for (int i = 0; i < faces.length; i++) {
            corners[i] = new int[whole.cornerCount(faces[i])];
            for (int k = 0; k < corners[i].length; k++) corners[i][k] = whole.corner(faces[i], k);
            all += corners[i].length;
        }
        var part = new Mesh(whole.coordinates(), corners);
        if (whole.hasNormals()) part = part.withNormals(normals(whole, faces, all));
        if (whole.hasTexture()) part = part.withTexture(texture(whole, faces, all));
        if (whole.hasColors()) part = part.withColors(colors(whole, faces, all));
        return part;
    }

    private static double[] colors(Mesh whole, int[] faces, int corners) {
        var colors = new double[3 * corners];
        int at = 0;
        for (int face : faces)
            for (int k = 0; k < whole.cornerCount(face); k++)
                for (int channel = 0; channel < 3; channel++)
                    colors[at++] = whole.color(face, k, channel);
        return colors;
    }

    private static double[] normals(Mesh whole, int[] faces, int corners) {
        var normals = new double[3 * corners];
        int at = 0;
        for (int face : faces)
            for (int k = 0; k < whole.cornerCount(face); k++)
                for (int axis = 0; axis < 3; axis++)
                    normals[at++] = whole.cornerNormal(face, k, axis);
        return normals;
    }

    private static double[] texture(Mesh whole, int[] faces, int corners) {
        var texture = new double[2 * corners];
        int at = 0;
        for (int face : faces)
            for (int k = 0; k < whole.cornerCount(face); k++) {
                texture[at++] = whole.textureS(face, k);
                texture[at++] = whole.textureT(face, k);
            }
        return texture;
    }
}
