package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.scene.shape.JoinedBlocks;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.Span;
import rasterlab.engine.scene.shape.SurfacePoint;

/**
 * How far blocks of a shape's cells are from the surface if each becomes one face, and which way
 * they face, whatever the camera.
 *
 * @param steps of the shape, u and v
 * @param side cells of a block each way
 * @param blocks of each patch, those along u one after another
 */
record BlockBounds(int u, int v, int side, List<List<BlockBound>> blocks) {
    /** Places along each side of a block that are compared. */
    private static final int PLACES = 3;

    /** How far a normal may be from the middle one beyond those that were looked at. */
    private static final double ROOM = 1.1;

    /**
     * One block.
     *
     * @param cells that it holds
     * @param middle its middle's x, y, z, world units
     * @param normal the outward one there, of length 1
     * @param radius the farthest that it reaches from the middle, world units
     * @param cone the most that its normals are off the middle's, radians
     * @param sag the largest distance of a face from the surface, world units
     * @param mixed the largest angle between a normal mixed from corners and the surface's, radians
     * @param rate the most that normals turn by for each world unit, radians
     */
    record BlockBound(
            int cells,
            double[] middle,
            double[] normal,
            double radius,
            double cone,
            double sag,
            double mixed,
            double rate) {}

    static BlockBounds of(SceneShape shape, int u, int v, int side) {
        List<List<BlockBound>> all = new ArrayList<>();
        for (Patch patch : shape.patches()) {
            List<BlockBound> blocks = new ArrayList<>();
            int rows = patch.vSteps(v);
            for (int j = 0; j < rows; j += side)
                for (int i = 0; i < u; i += side)
                    blocks.add(
                            of(
                                    patch,
                                    Math.min(side, u - i) * Math.min(side, rows - j),
                                    at(patch.u(), i, u),
                                    at(patch.u(), i + side, u),
                                    at(patch.v(), j, rows),
                                    at(patch.v(), j + side, rows)));
            all.add(blocks);
        }
        return new BlockBounds(u, v, side, all);
    }

    /** Blocks of a patch along u. */
    int columns() {
        return JoinedBlocks.count(u, side);
    }

    private static double at(Span span, int k, int steps) {
        return span.from() + (span.to() - span.from()) * Math.min(k, steps) / steps;
    }

    private static BlockBound of(
            Patch patch, int cells, double u0, double u1, double v0, double v1) {
        var point = new SurfacePoint();
        patch.at((u0 + u1) / 2, (v0 + v1) / 2, point);
        double[] middle = {point.x(), point.y(), point.z()};
        double[] normal = {point.normalX(), point.normalY(), point.normalZ()};
        double radius = 0;
        double cone = 0;
        for (int k = 0; k < 9; k++) {
            double v = v0 + (v1 - v0) * (k / 3) / 2;
            patch.at(u0 + (u1 - u0) * (k % 3) / 2, v, point);
            double x = point.x() - middle[0];
            double y = point.y() - middle[1];
            double z = point.z() - middle[2];
            radius = Math.max(radius, Math.sqrt(x * x + y * y + z * z));
            double cosine =
                    point.normalX() * normal[0]
                            + point.normalY() * normal[1]
                            + point.normalZ() * normal[2];
            cone = Math.max(cone, Math.acos(Math.max(-1, Math.min(1, cosine))));
        }
        if (patch.isFlat()) return new BlockBound(cells, middle, normal, ROOM * radius, 0, 0, 0, 0);
        var cell = new SurfaceCell(patch, PLACES);
        cell.look(u0, u1, v0, v1);
        return new BlockBound(
                cells,
                middle,
                normal,
                ROOM * radius,
                ROOM * cone,
                cell.sag(),
                cell.mixed(),
                cell.rate());
    }
}
