package rasterlab.engine.scene.catalogue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.shape.Placed;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.ShapeSurfaces;
import rasterlab.engine.transform.SphericalView;

/** Puts shapes together into a scene. */
final class Parts {
    private static final int BACKGROUND_RGB = 0x202B38;

    private final DoubleStream.Builder xyz = DoubleStream.builder();
    private final List<int[]> faces = new ArrayList<>();
    private final DoubleStream.Builder normals = DoubleStream.builder();
    private final DoubleStream.Builder texture = DoubleStream.builder();
    private final List<Appearance> finishes = new ArrayList<>();
    private final IntStream.Builder finishOf = IntStream.builder();
    private final List<SceneShape> shapes = new ArrayList<>();
    private int vertexCount;

    /**
     * @param uSteps as {@link SceneShape#faces} takes them
     */
    Parts add(Appearance finish, SceneShape shape, int uSteps, int vSteps) {
        Mesh mesh = shape.faces(uSteps, vSteps);
        for (int v = 0; v < mesh.vertexCount(); v++)
            xyz.add(mesh.x(v)).add(mesh.y(v)).add(mesh.z(v));
        for (int f = 0; f < mesh.faceCount(); f++) addFace(mesh, f);
        vertexCount += mesh.vertexCount();
        finishes.add(finish);
        shapes.add(shape);
        return this;
    }

    /** A shape of flat sides. */
    Parts add(Appearance finish, SceneShape shape) {
        return add(finish, shape, 1, 1);
    }

    /** A shape of flat sides in its place. */
    Parts add(Appearance finish, SceneShape shape, Matrix4d toWorld) {
        return add(finish, new Placed(shape, toWorld));
    }

    private void addFace(Mesh mesh, int f) {
        int[] corners = new int[mesh.cornerCount(f)];
        for (int k = 0; k < corners.length; k++) {
            corners[k] = vertexCount + mesh.corner(f, k);
            for (int axis = 0; axis < 3; axis++) normals.add(mesh.cornerNormal(f, k, axis));
            texture.add(mesh.textureS(f, k)).add(mesh.textureT(f, k));
        }
        faces.add(corners);
        finishOf.add(finishes.size());
    }

    /**
     * @param pictureScale as {@link Scene} takes it
     */
    Scene scene(String name, SceneLight light, SphericalView camera, double pictureScale) {
        Mesh mesh =
                new Mesh(xyz.build().toArray(), faces.toArray(int[][]::new))
                        .withNormals(normals.build().toArray())
                        .withTexture(texture.build().toArray());
        return new Scene(
                        name,
                        mesh,
                        finishes,
                        finishOf.build().toArray(),
                        light,
                        BACKGROUND_RGB,
                        camera,
                        pictureScale)
                .of(new ShapeSurfaces(shapes));
    }
}
