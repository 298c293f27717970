package rasterlab.engine.scene.obj;

import rasterlab.engine.scene.Mesh;

/**
 * Moves the middle of a model's bounding box to the origin and scales it by a power of two so that
 * its farthest vertex is more than {@value #RADIUS}/2 and at most {@value #RADIUS} world units
 * away. Scaling by a power of two rounds nothing.
 */
final class Fit {
    static final double RADIUS = 100;

    private Fit() {}

    static Mesh into(ObjModel model, UpAxis up) {
        int[][] faces = new int[model.faceCount()][];
        int corners = 0;
        for (int f = 0; f < faces.length; f++) {
            faces[f] = new int[model.cornerCount(f)];
            for (int k = 0; k < faces[f].length; k++) faces[f][k] = model.position(f, k);
            corners += faces[f].length;
        }
        Mesh mesh =
                new Mesh(up.toScene(fitted(model.positions(), faces)), faces)
                        .withNormals(up.toScene(normals(model, corners)));
        return hasTexture(model) ? mesh.withTexture(texture(model, corners)) : mesh;
    }

    /** Only vertices that a face has count; others stay where no one looks. */
    private static double[] fitted(double[] xyz, int[][] faces) {
        double[] middle = middle(xyz, faces);
        double farthest = 0;
        for (int[] face : faces)
            for (int v : face)
                farthest =
                        Math.max(
                                farthest,
                                Math.hypot(
                                        Math.hypot(
                                                xyz[3 * v] - middle[0], xyz[3 * v + 1] - middle[1]),
                                        xyz[3 * v + 2] - middle[2]));
        double scale = Math.scalb(1.0, Math.getExponent(RADIUS / farthest));
        if (!(scale > 0 && scale < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "model must have a radius that can be scaled to %s, got %s"
                            .formatted(RADIUS, farthest));
        double[] fitted = new double[xyz.length];
        for (int[] face : faces)
            for (int v : face)
                for (int i = 0; i < 3; i++)
                    fitted[3 * v + i] = scale * (xyz[3 * v + i] - middle[i]);
        return fitted;
    }

    private static double[] middle(double[] xyz, int[][] faces) {
        double[] middle = new double[3];
        for (int i = 0; i < 3; i++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int[] face : faces)
                for (int v : face) {
                    low = Math.min(low, xyz[3 * v + i]);
                    high = Math.max(high, xyz[3 * v + i]);
                }
            middle[i] = low / 2 + high / 2;
        }
        return middle;
    }

    private static double[] normals(ObjModel model, int corners) {
        double[] all = model.normals();
        double[] normals = new double[3 * corners];
        int at = 0;
        for (int f = 0; f < model.faceCount(); f++)
            for (int k = 0; k < model.cornerCount(f); k++, at += 3)
                System.arraycopy(all, 3 * model.normal(f, k), normals, at, 3);
        return normals;
    }

    private static boolean hasTexture(ObjModel model) {
        for (int f = 0; f < model.faceCount(); f++) if (model.texturePlace(f, 0) >= 0) return true;
        return false;
    }

    /** (0, 0) where a corner has no place. */
    private static double[] texture(ObjModel model, int corners) {
        double[] all = model.texturePlaces();
        double[] texture = new double[2 * corners];
        int at = 0;
        for (int f = 0; f < model.faceCount(); f++)
            for (int k = 0; k < model.cornerCount(f); k++, at += 2) {
                int place = model.texturePlace(f, k);
                if (place >= 0) System.arraycopy(all, 2 * place, texture, at, 2);
            }
        return texture;
    }
}
