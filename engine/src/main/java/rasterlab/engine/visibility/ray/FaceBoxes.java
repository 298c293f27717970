package rasterlab.engine.visibility.ray;

import rasterlab.engine.scene.Mesh;

/** The box round each face in the world, a little wider than the face against rounding. */
final class FaceBoxes {
    /** How much wider, as a share of the faces' largest coordinate. */
    private static final double MARGIN = 1e-9;

    private final double[] boxes;

    FaceBoxes(Mesh mesh) {
        boxes = new double[6 * mesh.faceCount()];
        double margin = MARGIN * size(mesh);
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int axis = 0; axis < 3; axis++) {
                double least = Double.POSITIVE_INFINITY;
                double most = Double.NEGATIVE_INFINITY;
                for (int k = 0; k < mesh.cornerCount(f); k++) {
                    double at = coordinate(mesh, mesh.corner(f, k), axis);
                    least = Math.min(least, at);
                    most = Math.max(most, at);
                }
                boxes[6 * f + axis] = least - margin;
                boxes[6 * f + 3 + axis] = most + margin;
            }
    }

    private static double size(Mesh mesh) {
        double size = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                for (int axis = 0; axis < 3; axis++)
                    size = Math.max(size, Math.abs(coordinate(mesh, mesh.corner(f, k), axis)));
        return size;
    }

    private static double coordinate(Mesh mesh, int vertex, int axis) {
        return axis == 0 ? mesh.x(vertex) : axis == 1 ? mesh.y(vertex) : mesh.z(vertex);
    }

    double least(int face, int axis) {
        return boxes[6 * face + axis];
    }

    double most(int face, int axis) {
        return boxes[6 * face + 3 + axis];
    }

    boolean apart(int one, int other) {
        for (int axis = 0; axis < 3; axis++)
            if (least(one, axis) > most(other, axis) || least(other, axis) > most(one, axis))
                return true;
        return false;
    }

    double middle(int face, int axis) {
        return (least(face, axis) + most(face, axis)) / 2;
    }
}
