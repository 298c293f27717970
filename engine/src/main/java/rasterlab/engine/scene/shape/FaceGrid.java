package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import rasterlab.engine.scene.Mesh;

/**
 * Puts the flat faces of a {@link Tessellation} together; equal places become one vertex.
 *
 * <p>Each corner has the surface's normal and texture coordinates of its own side of a seam; at a
 * pole those of the middle of the step of u.
 */
final class FaceGrid {
    private final Tessellation asked;
    private final Optional<JoinedBlocks> joins;
    private final NumberedPlaces vertices = new NumberedPlaces();
    private final List<int[]> faces = new ArrayList<>();
    private final DoubleStream.Builder normals = DoubleStream.builder();
    private final DoubleStream.Builder texture = DoubleStream.builder();
    private final SurfacePoint point = new SurfacePoint();

    FaceGrid(Tessellation asked, Optional<JoinedBlocks> joins) {
        this.asked = asked;
        this.joins = joins;
    }

    Mesh mesh() {
        List<Patch> patches = asked.shape().patches();
        for (int p = 0; p < patches.size(); p++)
            if (joins.isPresent()) new BlockFaces(this, p, joins.get()).add();
            else addCells(patches.get(p), 0, asked.uSteps(), 0, rows(patches.get(p)));
        return new Mesh(vertices.coordinates(), faces.toArray(int[][]::new))
                .withNormals(normals.build().toArray())
                .withTexture(texture.build().toArray());
    }

    Tessellation asked() {
        return asked;
    }

    /** Steps of v on a patch. */
    int rows(Patch patch) {
        return patch.vSteps(asked.vSteps());
    }

    /** Adds a face for each cell. */
    void addCells(Patch patch, int fromU, int toU, int fromV, int toV) {
        for (int i = fromU; i < toU; i++)
            for (int j = fromV; j < toV; j++) addFace(patch, i, i + 1, j, j + 1);
    }

    /** Adds one face over all cells between two steps of u and two of v. */
    void addFace(Patch patch, int fromU, int toU, int fromV, int toV) {
        double low = patch.v().at(fromV, rows(patch));
        double high = patch.v().at(toV, rows(patch));
        double middle = patch.u().between(fromU, toU, asked.uSteps());
        int[] face = new int[4];
        int corners = 0;
        face[corners++] = corner(patch, fromU, low, middle);
        if (!patch.isPole(low)) face[corners++] = corner(patch, toU, low, middle);
        face[corners++] = corner(patch, toU, high, middle);
        if (!patch.isPole(high)) face[corners++] = corner(patch, fromU, high, middle);
        faces.add(Arrays.copyOf(face, corners));
    }

    /** Adds a triangle from a place to two corners, each a step of u and one of v. */
    void addTriangle(Patch patch, double u, double v, int[] second, int[] third) {
        patch.at(u, v, point);
        putLook();
        faces.add(
                new int[] {
                    vertex(),
                    corner(patch, second[0], patch.v().at(second[1], rows(patch)), u),
                    corner(patch, third[0], patch.v().at(third[1], rows(patch)), u)
                });
    }

    /** The vertex at step {@code i} of u; its normal and texture coordinates are put down. */
    private int corner(Patch patch, int i, double v, double middle) {
        boolean pole = patch.isPole(v);
        if (pole) {
            patch.at(middle, v, point);
            putLook();
        }
        patch.at(patch.u().at(i, asked.uSteps()), v, point);
        if (!pole) putLook();
        return vertex();
    }

    private void putLook() {
        normals.add(point.normalX).add(point.normalY).add(point.normalZ);
        texture.add(point.s).add(point.t);
    }

    private int vertex() {
        return vertices.number(point.x, point.y, point.z);
    }
}
