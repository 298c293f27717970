package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;

/** Puts the meshes of a scene's shapes, in other steps, together again. */
final class ShapeScene {
    private final DoubleStream.Builder xyz = DoubleStream.builder();
    private final List<int[]> faces = new ArrayList<>();
    private final DoubleStream.Builder normals = DoubleStream.builder();
    private final DoubleStream.Builder texture = DoubleStream.builder();
    private final IntStream.Builder finishOf = IntStream.builder();
    private int vertices;

    /** Adds a shape's faces, which get its finish. */
    void add(Mesh mesh, int finish) {
        for (int v = 0; v < mesh.vertexCount(); v++)
            xyz.add(mesh.x(v)).add(mesh.y(v)).add(mesh.z(v));
        for (int f = 0; f < mesh.faceCount(); f++) {
            int[] corners = new int[mesh.cornerCount(f)];
            for (int k = 0; k < corners.length; k++) {
                corners[k] = vertices + mesh.corner(f, k);
                for (int axis = 0; axis < 3; axis++) normals.add(mesh.cornerNormal(f, k, axis));
                texture.add(mesh.textureS(f, k)).add(mesh.textureT(f, k));
            }
            faces.add(corners);
            finishOf.add(finish);
        }
        vertices += mesh.vertexCount();
    }

    /** The scene with these faces instead of its own. */
    Scene of(Scene from) {
        Mesh mesh =
                new Mesh(xyz.build().toArray(), faces.toArray(int[][]::new))
                        .withNormals(normals.build().toArray())
                        .withTexture(texture.build().toArray());
        return of(from, mesh, finishOf.build().toArray());
    }

    /** The scene with the faces of its only shape instead of its own. */
    static Scene of(Scene from, Mesh mesh) {
        return of(from, mesh, new int[mesh.faceCount()]);
    }

    private static Scene of(Scene from, Mesh mesh, int[] finishOf) {
        return new Scene(
                from.name(),
                mesh,
                from.finishes(),
                finishOf,
                from.light(),
                from.backgroundRgb(),
                from.defaultCamera(),
                from.pictureScale(),
                from.surfaces());
    }
}
